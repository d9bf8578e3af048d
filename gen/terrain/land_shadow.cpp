#include "terrain/land_shadow.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elementary.h"
#include "core/parallel.h"
#include "light/daylight.h"

namespace wold::terrain {
namespace {

constexpr std::size_t plans_side_by_side = 1025;

glm::dvec2 across(const glm::dvec2& towards) { return {towards.y, -towards.x}; }

/// How far along a line the square about 0 ends, `aside_m` beside its middle.
double end_m(double half_m, const glm::dvec2& towards, double aside_m) {
  const glm::dvec2 beside_m = across(towards) * aside_m;
  double end_m = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis)
    if (std::abs(towards[axis]) > 1e-9)
      end_m =
          std::min(end_m, (std::copysign(half_m, towards[axis]) - beside_m[axis]) / towards[axis]);
  return end_m;
}

}  // namespace

LandShadow::LandShadow(const Surroundings& land, const glm::dvec3& to_sun, double reach_m)
    : square_(land.square()) {
  constexpr double overhead_rad = radians(85.0);
  const double elevation_rad = math::asin(std::clamp(to_sun.z, -1.0, 1.0));
  if (elevation_rad > overhead_rad) return;
  upper_edge_rise_ = math::tan(elevation_rad + sun_disc::half_width_rad);
  lower_edge_rise_ = math::tan(elevation_rad - sun_disc::half_width_rad);
  const double azimuth_rad = math::atan2(to_sun.x, to_sun.y);
  for (const double offset_rad : sun_disc::offsets_rad) {
    const glm::dvec2 towards(light::direction_of(azimuth_rad + offset_rad, 0.0));
    plans_.push_back({towards, std::vector<Rays>(plans_side_by_side)});
    const double half_m = half_width_m(towards);
    parallel_for(plans_side_by_side, [&](std::size_t i) {
      const double aside = 2.0 * static_cast<double>(i) / (plans_side_by_side - 1.0) - 1.0;
      plans_.back().rays[i] = highest(land, towards, aside * half_m, reach_m);
    });
  }
}

double LandShadow::half_width_m(const glm::dvec2& towards) const {
  return 0.5 * square_.size_m * (std::abs(towards.x) + std::abs(towards.y));
}

LandShadow::Rays LandShadow::highest(const Surroundings& land, const glm::dvec2& towards,
                                     double aside_m, double reach_m) const {
  constexpr double spacing = 0.005, none = -std::numeric_limits<double>::infinity();
  const double half_m = 0.5 * square_.size_m;
  const glm::dvec2 begin_m = square_.corner_m + half_m + across(towards) * aside_m;
  const double border_m = end_m(half_m, towards, aside_m);
  Rays highest{none, none};
  double step_m = land.step_m(begin_m + towards * border_m);
  for (double beyond_m = step_m; beyond_m < reach_m;) {
    const double along_m = border_m + beyond_m;
    const glm::dvec2 at_m = begin_m + towards * along_m;
    const double height_m = land.coarse_height_m(at_m);
    highest.of_upper_edge = std::max(highest.of_upper_edge, height_m - along_m * upper_edge_rise_);
    highest.of_lower_edge = std::max(highest.of_lower_edge, height_m - along_m * lower_edge_rise_);
    step_m = land.step_m(at_m);
    beyond_m += std::max(0.5 * step_m, spacing * beyond_m);
  }
  return highest;
}

double LandShadow::sun_seen(const glm::dvec3& at_m) const {
  if (plans_.empty()) return 1.0;
  double seen = 0.0;
  for (const Plans& plans : plans_) seen += sun_seen(at_m, plans);
  return seen / static_cast<double>(plans_.size());
}

double LandShadow::sun_seen(const glm::dvec3& at_m, const Plans& plans) const {
  const glm::dvec2 from_middle_m = glm::dvec2(at_m) - square_.corner_m - 0.5 * square_.size_m;
  const double along_m = glm::dot(from_middle_m, plans.towards);
  const double aside = glm::dot(from_middle_m, across(plans.towards)) / half_width_m(plans.towards);
  const double place = std::clamp(0.5 + 0.5 * aside, 0.0, 1.0) * (plans_side_by_side - 1.0);
  const auto i = std::min(static_cast<std::size_t>(place), plans_side_by_side - 2);
  const double part = place - static_cast<double>(i);
  const double none_below_m =
      std::lerp(plans.rays[i].of_upper_edge, plans.rays[i + 1].of_upper_edge, part) +
      along_m * upper_edge_rise_;
  const double all_above_m =
      std::lerp(plans.rays[i].of_lower_edge, plans.rays[i + 1].of_lower_edge, part) +
      along_m * lower_edge_rise_;
  return sun_disc::seen((at_m.z - none_below_m) / (all_above_m - none_below_m));
}

}  // namespace wold::terrain
