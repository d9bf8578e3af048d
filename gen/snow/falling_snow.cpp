#include "snow/falling_snow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/random.h"

namespace wold::snow {
namespace {

constexpr int usual_flakes = 30000;

/// The air between two distances from the eye and the flakes that it shows.
struct Shell {
  double from_m;
  double to_m;
  PeriodicCube cube;
  Population population;
};

/// The smallest ball about all that is seen between two distances, with its centre straight ahead:
/// about the corners of the view at the farther one, or at both.
struct Ball {
  glm::dvec3 centre_m;
  double radius_m;
};

Ball ball_about(const Frustum& frustum, double from_m, double to_m) {
  const double cosine = math::cos(frustum.half_angle());
  const double sine = math::sin(frustum.half_angle());
  const double ahead_m = std::min(to_m * cosine, 0.5 * (from_m + to_m) / cosine);
  const double to_corners_m = math::hypot(to_m * cosine - ahead_m, to_m * sine);
  return {frustum.eye_m() + ahead_m * frustum.ahead(), std::max(to_corners_m, to_m - ahead_m)};
}

double drawn_fraction(double distance_m, double reach_m) {
  return math::exp(-distance_m / reach_m);
}

/// Flakes per steradian that are drawn beyond a distance: n times the integral of r^2 k(r).
double drawn_beyond(double distance_m, const NearField& field) {
  const double x = distance_m / field.reach_m;
  return field.number_per_m3 * math::pow(field.reach_m, 3) * (x * x + 2.0 * x + 2.0) *
         math::exp(-x);
}

std::vector<Shell> shells_of(const Frustum& frustum, const NearField& field,
                             double farthest_own_way_m, std::uint64_t key) {
  std::vector<Shell> shells;
  double from_m = 0.0;
  double to_m = 1.0;
  while (drawn_beyond(from_m, field) * frustum.solid_angle_sr() > 0.5) {
    const Ball ball = ball_about(frustum, from_m, to_m);
    const double side_m = 2.0 * (ball.radius_m + farthest_own_way_m);
    const double number =
        field.number_per_m3 * drawn_fraction(from_m, field.reach_m) * side_m * side_m * side_m;
    shells.push_back({from_m,
                      to_m,
                      {ball.centre_m, side_m},
                      {random_bits({key, key_of("shell"), shells.size(), 0}),
                       static_cast<std::uint64_t>(std::llround(number))}});
    from_m = to_m;
    to_m *= std::numbers::sqrt2;  // the least work
  }
  return shells;
}

/// Picks what is seen of a shell's flakes: first by where they drift, then, as many at a time as
/// there are lanes, by where their own gusts and sway take them.
class Picker {
 public:
  Picker(const FlakeMotion& motion, const FlakeMotion::Moment& moment, const Frustum& frustum,
         const FlakeCuller& culler, double reach_m, const Shell& shell)
      : motion_(motion),
        moment_(moment),
        frustum_(frustum),
        culler_(culler),
        air_(FlakeMotion::air(shell.population, shell.cube, moment, frustum.eye_m())),
        from_m_(static_cast<float>(shell.from_m)),
        to_m_(static_cast<float>(shell.to_m)),
        reach_m_(static_cast<float>(reach_m)),
        margin_m_(static_cast<float>(motion.farthest_own_way_m())) {}

  /// Appends the flakes of columns that may be seen, as parts of shell `of`.
  void find(std::size_t of, std::vector<Range>& parts) const {
    const Population& population = air_.population;
    const std::uint32_t columns = 1U << (2 * population.bits());
    std::uint32_t first = 0;
    for (std::uint32_t column = 0; column <= columns; ++column) {
      if (column < columns && column_may_be_seen(column)) continue;
      split(of, population.flakes_before(first), population.flakes_before(column), parts);
      first = column + 1;
    }
  }

  /// See() has to follow the last one.
  void pick(std::uint64_t first, std::uint64_t last, std::vector<SeenFlake>& seen) {
    FlakeMotion::Drifting drifting;
    for (; first < last; first += lanes) {
      motion_.drift(air_, first, drifting);
      const Chosen chosen = may_be_seen(drifting, std::min<std::uint64_t>(lanes, last - first));
      for (std::size_t n = 0; n < chosen.count; ++n) {
        waiting_.set(count_++, drifting, chosen.lane[n]);
        if (count_ == lanes) see(seen);
      }
    }
  }

  /// Sees those that wait.
  void see(std::vector<SeenFlake>& seen) {
    motion_.fly(waiting_, moment_, flying_);
    culler_.see(
        flying_, count_,
        [&](std::size_t i) {
          const glm::vec3 from_eye = flying_.from_eye.at(i);
          const float distance2 = glm::dot(from_eye, from_eye);
          const float far_m = drawn_to_m(motion_.deviate(waiting_.key[i]));
          return static_cast<int>(distance2 > from_m_ * from_m_) &
                 static_cast<int>(distance2 <= far_m * far_m) &
                 static_cast<int>(motion_.is_there(waiting_.key[i], flying_.diameter[i], moment_));
        },
        seen);
    count_ = 0;
  }

 private:
  /// Where the middle of a column's width is, relative to the cube's, in its sides; and a second
  /// time where it is in two parts, at either end of the cube.
  struct Places {
    std::array<float, 2> place;
    std::size_t count;
  };
  Places places_of(std::uint32_t column, std::uint32_t way) const {
    const int bits = air_.population.bits();
    const std::uint64_t middle =
        ((static_cast<std::uint64_t>(column) << 32) + (1ULL << 31)) >> bits;
    const float place =
        0x1p-32F *
        static_cast<float>(static_cast<std::int32_t>(static_cast<std::uint32_t>(middle) + way));
    const bool parted = std::abs(place) + std::ldexp(0.5F, -bits) > 0.5F;
    return {{place, place - std::copysign(1.0F, place)}, parted ? 2U : 1U};
  }

  bool column_may_be_seen(std::uint32_t column) const {
    const int bits = air_.population.bits();
    if (bits == 0) return true;
    const Places xs = places_of(column, air_.way.x), ys = places_of(column >> bits, air_.way.y);
    const std::uint32_t high = 1U << bits;
    for (std::size_t x = 0; x < xs.count; ++x)
      for (std::size_t y = 0; y < ys.count; ++y)
        for (std::uint32_t z = 0; z < high; ++z) {
          const float place_z = (static_cast<float>(z) + 0.5F) / static_cast<float>(high) - 0.5F;
          if (cell_may_be_seen(air_.centre_from_eye_m +
                               air_.side_m * glm::vec3(xs.place[x], ys.place[y], place_z)))
            return true;
        }
    return false;
  }

  /// A cube as wide as a column, by the ball about it.
  bool cell_may_be_seen(const glm::vec3& from_eye) const {
    constexpr float half_diagonal = 0.8660254F;
    const float radius_m =
        margin_m_ + half_diagonal * std::ldexp(air_.side_m, -air_.population.bits());
    const float distance = glm::length(from_eye);
    return distance > from_m_ - radius_m && distance <= to_m_ + radius_m &&
           frustum_.touches_from_eye(from_eye, radius_m);
  }

  WOLD_LANES_WIDE Chosen may_be_seen(const FlakeMotion::Drifting& drifting, std::size_t end) const {
    const Frustum frustum = frustum_;
    const float from_m = from_m_;
    Lanes<float> drawn_to, margin;
    for (std::size_t i = 0; i < lanes; ++i) {
      drawn_to[i] = drawn_to_m(motion_.deviate(drifting.key[i]));
      margin[i] = motion_.farthest_own_way_m(drifting.key[i], moment_);
    }
    return Chosen::by(
        [&](std::size_t i) {
          const glm::vec3 from_eye = drifting.from_eye.at(i);
          const float distance2 = glm::dot(from_eye, from_eye);
          const float near = greater(0.0F, from_m - margin[i]);
          const float far = drawn_to[i] + margin[i];
          return static_cast<int>(distance2 > near * near) &
                 static_cast<int>(distance2 <= far * far) &
                 static_cast<int>(frustum.touches_from_eye(from_eye, margin[i]));
        },
        end);
  }

  /// Of the shell's flakes the fraction exp(-(r - from) / reach) is drawn at a distance r.
  float drawn_to_m(float deviate) const { return std::min(to_m_, from_m_ + reach_m_ * deviate); }

  const FlakeMotion& motion_;
  const FlakeMotion::Moment& moment_;
  const Frustum& frustum_;
  const FlakeCuller& culler_;
  FlakeMotion::Air air_;
  float from_m_, to_m_, reach_m_, margin_m_;
  FlakeMotion::Drifting waiting_ = {};
  FlakeLanes flying_;
  std::size_t count_ = 0;
};

/// Neighbouring parts of one shell that one thread does together: ranges of them.
std::vector<Range> gathered(const std::vector<Range>& parts) {
  constexpr std::uint64_t enough = 128 * lanes;
  std::vector<Range> tasks;
  std::uint64_t flakes = enough;
  for (std::uint64_t part = 0; part < parts.size(); ++part) {
    if (flakes >= enough || parts[part].of != tasks.back().of) {
      tasks.push_back({parts[part].of, part, part});
      flakes = 0;
    }
    tasks.back().last = part + 1;
    flakes += parts[part].last - parts[part].first;
  }
  return tasks;
}

std::optional<FlakeMotion> motion_of(const scene::PrecipitationPart& part, const Weather& weather,
                                     Falling what,
                                     const std::shared_ptr<const wind::AirFlow>& air) {
  const double heaviest = weather.heaviest_mm_h();
  if (heaviest <= 0.0) return std::nullopt;
  return FlakeMotion(part, weather, heaviest, what, air);
}

/// Of what falls; 0: as many as usual.
int asked_for(const scene::PrecipitationPart& part, Falling what) {
  return what == Falling::rain ? part.rainfall.drops : part.snowfall.flakes;
}

}  // namespace

FallingSnow::FallingSnow(const scene::PrecipitationPart& part, const Weather& weather,
                         const FlakePictures& pictures, Falling what,
                         const std::shared_ptr<const wind::AirFlow>& air)
    : what_(what),
      weather_(weather),
      pictures_(pictures),
      motion_(motion_of(part, weather, what, air)),
      key_(random_bits(
          {part.seed, key_of(what == Falling::rain ? "rain" : "snow"), 0, key_of("flakes")})),
      flakes_(asked_for(part, what) > 0 ? asked_for(part, what) : usual_flakes),
      shutter_s_(what == Falling::rain ? part.rainfall.shutter_s : part.snowfall.shutter_s) {
  if (part.wind.field == scene::WindPattern::tornado && what == Falling::snow)
    tornado_.emplace(part, key_, static_cast<std::uint64_t>(flakes_));
}

NearField FallingSnow::field_of(double rate_mm_h, double solid_angle_sr) const {
  if (what_ == Falling::rain)
    return near_rain(rate_mm_h, weather_.heaviest_mm_h(), solid_angle_sr, flakes_);
  return near_field(rate_mm_h, solid_angle_sr, flakes_);
}

SeenFlakes FallingSnow::at(double time_s, const SnowView& view, const Heightfield& ground) const {
  const double rate_mm_h = what_ == Falling::rain
                               ? weather_.falling_rain_mm_h(time_s, view.eye_m.z)
                               : weather_.falling_snow_mm_h(time_s, view.eye_m.z);
  constexpr double min_rate_mm_h = 1e-3;  // a flake in 2 m3, and none of them seen
  if (!motion_ || rate_mm_h < min_rate_mm_h) return {};
  const Frustum frustum(view);
  const NearField field = field_of(rate_mm_h, frustum.solid_angle_sr());
  const FlakeMotion::Moment moment = motion_->moment(time_s, rate_mm_h, glm::dvec2(view.eye_m));
  const FlakeLook look(pictures_, frustum, shutter_s_, what_);
  const FlakeCuller culler(look, frustum, ground);
  const std::vector<Shell> shells = shells_of(frustum, field, motion_->farthest_own_way_m(), key_);
  std::vector<Range> parts;
  const auto picker = [&](std::size_t shell) {
    return Picker(*motion_, moment, frustum, culler, field.reach_m, shells[shell]);
  };
  for (std::size_t shell = 0; shell < shells.size(); ++shell) picker(shell).find(shell, parts);
  FlakeCollector collector;
  const std::vector<Range> tasks = gathered(parts);
  collector.add(tasks.size(), [&](std::size_t task, std::vector<SeenFlake>& seen) {
    Picker own = picker(tasks[task].of);
    for (std::uint64_t part = tasks[task].first; part < tasks[task].last; ++part)
      own.pick(parts[part].first, parts[part].last, seen);
    own.see(seen);
  });
  const FlakeLook whirled(pictures_, frustum, std::max(shutter_s_, whirl_shutter_s));
  if (tornado_) collector.add(*tornado_, time_s, whirled, frustum, ground);
  return {collector.farthest_first(view.eye_m), field.fog_extinction_per_m};
}

}  // namespace wold::snow
