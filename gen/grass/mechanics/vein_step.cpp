#include "grass/mechanics/vein_step.h"

#include <algorithm>
#include <cmath>

namespace wold::grass {
namespace {

constexpr std::size_t segments = vein_segments;
template <class T>
using OfSegments = std::array<T, segments>;
using Angles = OfSegments<double>;

/// Largest turn of a segment per iteration, rad, and the one that ends the iterations.
constexpr double largest_turn = 0.3;
constexpr double smallest_turn = 1e-8;
constexpr int max_iterations = 100;

/// The objective of a step at given angles: its value and, to second order, how it changes as
/// segments turn and points move.
struct Objective {
  double value = 0.0;
  // Joints, each between a segment and the one before it.
  Angles moment{};
  Angles stiffness{};
  // Segments.
  OfSegments<glm::dvec2> lever{};  ///< way of its end per turn
  Angles geometric{};              ///< what the forces beyond it add to its stiffness as it turns
  // Points.
  VeinPoints::OfPoints<glm::dvec2> force{};  ///< that holds it, per metre of objective
  VeinPoints::OfPoints<glm::dvec2> held{};   ///< the same per metre that it moves
};

/// What stays the same during a step.
class Step {
 public:
  Step(const VeinPoints& points, const VeinLoad& load, double seconds)
      : load_(load), mass_kg_(points.mass_kg), before_(turns(points, load.clamp)) {
    const double inertia = 1.0 / (seconds * seconds);
    const double drag = load.air_damping_per_s / seconds;
    inertia_per_s2_ = inertia + drag;
    damping_ = load.bending_damping_s / seconds;
    const double carried_s = seconds * inertia / inertia_per_s2_;
    for (std::size_t i = 0; i <= segments; ++i)
      aim_m_[i] = points.position_m[i] + carried_s * points.velocity_m_s[i];
  }

  Objective at(const Angles& angle) const {
    Objective objective;
    add_joints(angle, objective);
    add_points(angle, objective);
    return objective;
  }

 private:
  void add_joints(const Angles& angle, Objective& to) const {
    for (std::size_t k = 0; k < segments; ++k) {
      const auto [wall, turgor] = joint_stiffness(load_, k);
      const double damping = damping_ * (wall + turgor);
      const double turn = angle[k] - (k > 0 ? angle[k - 1] : load_.clamp);
      const double bent = turn - load_.set[k];
      const double turned = turn - before_[k];
      to.value += 0.5 * (wall * bent * bent + turgor * turn * turn + damping * turned * turned);
      to.moment[k] = wall * bent + turgor * turn + damping * turned;
      to.stiffness[k] = wall + turgor + damping;
    }
  }

  void add_points(const Angles& angle, Objective& to) const {
    const double segment_m = load_.length_m / segments;
    OfSegments<glm::dvec2> way_m;
    glm::dvec2 place_m(0.0);
    for (std::size_t k = 0; k < segments; ++k) {
      way_m[k] = segment_m * along(angle[k]);
      to.lever[k] = {way_m[k].y, -way_m[k].x};
      place_m += way_m[k];
      add_point(k + 1, place_m, to);
    }
    glm::dvec2 beyond(0.0);
    for (std::size_t k = segments; k-- > 0;) {
      beyond += to.force[k + 1];
      to.geometric[k] = -glm::dot(way_m[k], beyond);
    }
  }

  void add_point(std::size_t i, const glm::dvec2& place_m, Objective& to) const {
    const double depth_m = ground_depth * load_.length_m;
    const double inertia = mass_kg_[i] * inertia_per_s2_;
    const double weight_n = mass_kg_[i] * gravity_m_s2;
    const glm::dvec2 off_m = place_m - aim_m_[i];
    to.value +=
        0.5 * inertia * glm::dot(off_m, off_m) + weight_n * weighted_height_m(place_m.y, load_);
    to.force[i] = inertia * off_m + glm::dvec2(0.0, weight_n * weight_fraction(place_m.y, load_));
    to.held[i] = {inertia, inertia + (place_m.y < 0.0 ? weight_n / depth_m : 0.0)};
  }

  const VeinLoad& load_;
  VeinPoints::OfPoints<double> mass_kg_;
  Angles before_;
  VeinPoints::OfPoints<glm::dvec2> aim_m_{};
  double inertia_per_s2_ = 0.0;
  double damping_ = 0.0;
};

/// The least that the part of a vein from a point on adds to the objective, over the turn of the
/// segment before that point and the way of the point: half a quadratic form and a linear one.
struct Beyond {
  double turn_turn = 0.0;
  glm::dvec2 turn_way{0.0};
  glm::dmat2 way_way{0.0};
  double turn = 0.0;
  glm::dvec2 way{0.0};
};

/// How a segment answers: its turn is free - by_way . way + by_turn * turn of the one before.
struct Answer {
  double free = 0.0, by_turn = 0.0;
  glm::dvec2 by_way{0.0};
};

/// Solves for Newton's turns, from the tip to the root and back as in the linear-quadratic
/// regulator (Riccati's recursion) and in Featherstone's articulated bodies: exact, in a time that
/// grows with the segments. False when the matrix is not positive definite.
bool solve(const Objective& objective, bool geometric, Angles& turn) {
  OfSegments<Answer> answers;
  const auto held = [&](std::size_t i) {
    return glm::dmat2(objective.held[i].x, 0.0, 0.0, objective.held[i].y);
  };
  Beyond beyond;
  beyond.way_way = held(segments);
  beyond.way = objective.force[segments];
  for (std::size_t k = segments; k-- > 0;) {
    const double joint = objective.stiffness[k];
    const double bends = geometric ? objective.geometric[k] : std::max(objective.geometric[k], 0.0);
    const glm::dvec2& lever = objective.lever[k];
    const glm::dvec2 carried = beyond.turn_way + beyond.way_way * lever;
    const double pivot = joint + bends + beyond.turn_turn + glm::dot(beyond.turn_way, lever) +
                         glm::dot(carried, lever);
    if (pivot <= 1e-9 * joint) return false;
    const double pull = objective.moment[k] + beyond.turn + glm::dot(beyond.way, lever);
    answers[k] = {-pull / pivot, joint / pivot, carried / pivot};
    beyond.way_way += held(k) - glm::outerProduct(carried, carried) / pivot;
    beyond.way += objective.force[k] - carried * (pull / pivot);
    beyond.turn_way = carried * (joint / pivot);
    beyond.turn_turn = joint - joint * joint / pivot;
    beyond.turn = joint * pull / pivot - objective.moment[k];
  }
  glm::dvec2 way(0.0);
  double before = 0.0;
  for (std::size_t k = 0; k < segments; ++k) {
    const Answer& answer = answers[k];
    turn[k] = answer.free + answer.by_turn * before - glm::dot(answer.by_way, way);
    way += objective.lever[k] * turn[k];
    before = turn[k];
  }
  return true;
}

double size_of(const Angles& turn) {
  double largest = 0.0;
  for (double by : turn) largest = std::max(largest, std::abs(by));
  return largest;
}

/// Newton's turn, no larger than largest_turn; where weight makes the matrix indefinite (a blade
/// about to buckle), without what makes it so.
Angles newton_turn(const Objective& objective) {
  Angles turn;
  if (!solve(objective, /*geometric=*/true, turn)) solve(objective, /*geometric=*/false, turn);
  const double largest = size_of(turn);
  if (largest > largest_turn)
    for (double& by : turn) by *= largest_turn / largest;
  return turn;
}

Angles minimum(const Step& step, Angles angle) {
  Objective now = step.at(angle);
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    Angles turn = newton_turn(now);
    Angles next;
    Objective then;
    double size = size_of(turn);
    for (;; size *= 0.5) {
      for (std::size_t k = 0; k < segments; ++k) next[k] = angle[k] + turn[k];
      if (size < smallest_turn) return next;
      then = step.at(next);
      if (then.value <= now.value) break;
      for (double& by : turn) by *= 0.5;
    }
    angle = next;
    now = then;
  }
  return angle;
}

}  // namespace

void step_vein(VeinPoints& points, const VeinLoad& load, double seconds) {
  points.angle = minimum(Step(points, load, seconds), points.angle);
  const auto place_m = places_m(points.angle, load.length_m);
  for (std::size_t i = 0; i <= segments; ++i) {
    const glm::dvec2 velocity_m_s = (place_m[i] - points.position_m[i]) / seconds;
    points.force_n[i] = points.mass_kg[i] * (velocity_m_s - points.velocity_m_s[i]) / seconds;
    points.velocity_m_s[i] = velocity_m_s;
  }
  points.position_m = place_m;
}

void settle_vein(VeinPoints& points, const VeinLoad& load) {
  constexpr double seconds = 10.0;
  constexpr double still_m_s = 1e-6;
  constexpr int max_steps = 100;
  for (int i = 0; i < max_steps; ++i) {
    step_vein(points, load, seconds);
    double fastest = 0.0;
    for (const glm::dvec2& velocity_m_s : points.velocity_m_s)
      fastest = std::max(fastest, glm::length(velocity_m_s));
    if (fastest < still_m_s) return;
  }
}

}  // namespace wold::grass
