#include "grass/dynamics.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "grass/ageing_curves.h"

namespace wold::grass {
namespace {

/// Largest shift of a blade's age, so that age stays monotone in weathering: d/dw (w + 4 o w (1-w))
/// >= 1 - 4 |o| > 0.
constexpr double largest_onset = 0.24;
/// How much older the tip is than the middle, half-way through.
constexpr double tip_lead = 0.16;

/// A bump that is 0 at both ends and 1 in the middle.
double midway(double x) { return 4.0 * x * (1.0 - x); }

/// The blade's horizontal heading and its two cross directions at a tangent of its plane.
struct CrossSection {
  CrossSection(const Blade& blade, const glm::vec2& tangent)
      : along(from_plane(blade, tangent)),
        side(from_plane(blade, {tangent.y, -tangent.x})),
        across(-blade.heading.y, blade.heading.x, 0.0F) {}
  glm::vec3 along, side, across;
};

/// Puts what a point stands for into another one of its blade and tissue.
void merge_into(Points& points, std::uint32_t to, std::uint32_t from) {
  const float share = points.area_m2[from] / (points.area_m2[to] + points.area_m2[from]);
  const auto mean = [&](auto& values) { values[to] += (values[from] - values[to]) * share; };
  mean(points.side_m);
  mean(points.across_m);
  mean(points.position_m);
  mean(points.albedo);
  mean(points.specular);
  points.rest_area_m2[to] += points.rest_area_m2[from];
  points.area_m2[to] += points.area_m2[from];
  points.rest_area_m2[from] = 0.0F;
  points.area_m2[from] = 0.0F;
}

void merge_blade(Points& points, std::uint32_t begin, std::uint32_t end, float distance_m) {
  for (std::uint32_t i = begin; i < end; ++i) {
    if (points.area_m2[i] == 0.0F) continue;
    for (std::uint32_t j = i + 1; j < end && points.arc_m[j] - points.arc_m[i] < distance_m; ++j) {
      if (points.area_m2[j] == 0.0F || points.vein[i] != points.vein[j]) continue;
      const glm::vec3 apart = points.position_m[i] - points.position_m[j];
      if (glm::dot(apart, apart) < distance_m * distance_m) merge_into(points, i, j);
    }
  }
}

}  // namespace

/// The two samples around a place on a blade (0 root to 1 tip), and how far it is from the lower.
struct PointDynamics::Between {
  explicit Between(float along) {
    const float place = along * WitheredBlade::steps;
    lower = std::min(static_cast<std::size_t>(place), std::size_t{WitheredBlade::steps} - 1);
    above = place - static_cast<float>(lower);
  }
  template <class T>
  T mix(const T& a, const T& b) const {
    return a + (b - a) * above;
  }
  std::size_t lower;
  float above;
};

AgeingModel::AgeingModel(const scene::Ageing& ageing, double fresh_specular)
    : ageing_(ageing),
      fresh_specular_(fresh_specular),
      water_(load_curve(CurveKind::water, ageing.water)),
      heaviest_load_(heaviest_load(ageing, water_)),
      colour_(ageing) {}

double AgeingModel::blade_age(const Blade& blade, double weathering) {
  const double onset = std::clamp(double{blade.onset}, -largest_onset, largest_onset);
  const double own = std::clamp(weathering + onset * midway(weathering), 0.0, 1.0);
  return blade.head_start + (1.0 - blade.head_start) * own;
}

double AgeingModel::local_age(double age, double along) {
  return std::clamp(age + tip_lead * midway(age) * (2.0 * along - 1.0), 0.0, 1.0);
}

BladePose AgeingModel::pose(const Blade& blade, double age, double snow) const {
  return blade_pose(blade, ageing_, 1.0 - water_(age), heaviest_load_(age), snow);
}

glm::vec3 AgeingModel::albedo(const Blade& blade, double age, double along) const {
  return glm::min(colour_(local_age(age, along)).albedo * blade.brightness, 0.99F);
}

float AgeingModel::specular(double age) const {
  return static_cast<float>(fresh_specular_ * (0.5 + 0.5 * water_(age)));
}

PointDynamics::PointDynamics(const AgeingModel& model, std::vector<Blade> blades, Points points,
                             double merge_distance_m)
    : model_(model),
      blades_(std::move(blades)),
      points_(std::move(points)),
      merge_distance_m_(static_cast<float>(merge_distance_m)),
      poses_(blades_.size()) {}

void PointDynamics::advance_to(double weathering) {
  weathering_ = weathering;
  parallel_for(blades_.size(), [&](std::size_t blade) {
    stand(blade, weathering, /*snow=*/0.0);
    merge_blade(points_, points_.blade_begin[blade], points_.blade_begin[blade + 1],
                merge_distance_m_);
  });
}

void PointDynamics::bear(double snow) {
  parallel_for(blades_.size(), [&](std::size_t blade) { stand(blade, weathering_, snow); });
}

void PointDynamics::stand(std::size_t blade, double weathering, double snow) {
  const WitheredBlade now = apply_forces(blade, weathering, snow);
  move(blade, now);
  update_frames(blade);
  update_material(blade, now);
}

PointDynamics::WitheredBlade PointDynamics::apply_forces(std::size_t number, double weathering,
                                                         double snow) {
  const Blade& blade = blades_[number];
  const double age = AgeingModel::blade_age(blade, weathering);
  poses_[number] = model_.pose(blade, age, snow);
  const float length_m = blade.length_m * poses_[number].length_scale;
  const BladeAxis axis(blade, poses_[number]);
  WitheredBlade now;
  for (int i = 0; i <= WitheredBlade::steps; ++i) {
    const float along = static_cast<float>(i) / WitheredBlade::steps;
    const auto place = static_cast<std::size_t>(i);
    now.axis[place] = axis.at(length_m * along);
    now.albedo[place] = model_.albedo(blade, age, double{along});
  }
  now.specular = model_.specular(age);
  return now;
}

void PointDynamics::move(std::size_t number, const WitheredBlade& now) {
  const Blade& blade = blades_[number];
  const BladePose& pose = poses_[number];
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const Between between(points_.arc_m[i] / blade.length_m);
    const AxisPoint axis = {
        between.mix(now.axis[between.lower].position_m, now.axis[between.lower + 1].position_m),
        glm::normalize(
            between.mix(now.axis[between.lower].tangent, now.axis[between.lower + 1].tangent))};
    const CrossSection section(blade, axis.tangent);
    const float width = points_.vein[i] != 0 ? pose.vein_width : pose.mesophyll_width;
    points_.position_m[i] =
        on_patch_m(blade, axis) +
        width * (points_.side_m[i] * section.side + points_.across_m[i] * section.across);
    points_.position_m[i].z = std::max(points_.position_m[i].z, 0.0F);
    points_.tangent[i] = section.along;
    points_.area_m2[i] = points_.rest_area_m2[i] * pose.length_scale * width;
  }
}

void PointDynamics::update_frames(std::size_t number) {
  const Blade& blade = blades_[number];
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const float distance = std::hypot(points_.side_m[i], points_.across_m[i]);
    if (points_.vein[i] != 0 || distance == 0.0F) {
      points_.normal[i] = glm::vec3(0.0F);
      continue;
    }
    const glm::vec3& t = points_.tangent[i];
    const CrossSection section(blade, {glm::dot(glm::vec2(t), blade.heading), t.z});
    points_.normal[i] =
        (points_.side_m[i] * section.side + points_.across_m[i] * section.across) / distance;
  }
}

void PointDynamics::update_material(std::size_t number, const WitheredBlade& now) {
  const float length_m = blades_[number].length_m;
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const Between between(points_.arc_m[i] / length_m);
    points_.albedo[i] = between.mix(now.albedo[between.lower], now.albedo[between.lower + 1]);
    points_.specular[i] = now.specular;
  }
}

}  // namespace wold::grass
