#include "grass/texel/snow_points.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/parallel.h"
#include "grass/geometry/axis.h"
#include "grass/geometry/snow_ridge.h"

namespace wold::grass {
namespace {

/// Area of a ridge's points over its own, for voxels of the size of a step.
float solid(const SnowRidge& ridge, float step_m) {
  return 1.0F + 0.5F * std::min(2.0F * ridge.half_height_m / step_m, 1.0F);
}

/// A point of a ridge.
struct SnowPoint {
  float arc_m;
  float area_m2;
  glm::vec3 position_m;
  glm::vec3 tangent;
  glm::vec3 up;
};

/// Two points within the ridge's section, opposite to each other; pairs turn by the golden angle
/// from step to step (Vogel 1979).
void add_pair(const Blade& blade, const SnowRidge& ridge, const AxisPoint& at, int step,
              float arc_m, float step_m, std::vector<SnowPoint>& points) {
  constexpr float golden_angle = 2.39996323F;
  constexpr float middle = 0.7071F;  // radius that halves the section
  const glm::vec3 across(-blade.heading.y, blade.heading.x, 0.0F);
  const glm::vec3 up = from_plane(blade, upper_side(at.tangent));
  const glm::vec3 centre_m = foot_m(blade) + from_plane(blade, ridge.centre_m);
  const float angle = golden_angle * static_cast<float>(step);
  const glm::vec3 offset_m = middle * (math::cos(angle) * ridge.half_width_m * across +
                                       math::sin(angle) * ridge.half_height_m * up);
  for (const float sign : {-1.0F, 1.0F}) {
    glm::vec3 place_m = centre_m + sign * offset_m;
    place_m.z = std::max(place_m.z, 0.0F);
    points.push_back({arc_m, 0.5F * solid(ridge, step_m) * ridge.area_m() * step_m, place_m,
                      from_plane(blade, at.tangent), up});
  }
}

std::vector<SnowPoint> points_on(const Blade& blade, const BladePose& pose, double step_m) {
  const float length_m = blade.length_m * pose.length_scale;
  const int steps = std::max(1, static_cast<int>(std::ceil(double{length_m} / step_m)));
  const float each_m = length_m / static_cast<float>(steps);
  const BladeAxis axis(blade, pose);
  std::vector<SnowPoint> points;
  for (int step = 0; step < steps; ++step) {
    const float along = (static_cast<float>(step) + 0.5F) / static_cast<float>(steps);
    const AxisPoint at = axis.at(length_m * along);
    const SnowRidge ridge = snow_ridge(blade, pose, along, at);
    if (ridge.half_height_m > 0.0F)
      add_pair(blade, ridge, at, step, blade.length_m * along, each_m, points);
  }
  return points;
}

void append(const std::vector<SnowPoint>& from, Points& to) {
  for (const SnowPoint& point : from) {
    to.arc_m.push_back(point.arc_m);
    to.area_m2.push_back(point.area_m2);
    to.position_m.push_back(point.position_m);
    to.tangent.push_back(point.tangent);
    to.normal.push_back(point.up);
  }
  to.blade_begin.push_back(static_cast<std::uint32_t>(to.size()));
}

}  // namespace

Points snow_points(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                   double step_m) {
  std::vector<std::vector<SnowPoint>> on_blade(blades.size());
  parallel_for(blades.size(),
               [&](std::size_t i) { on_blade[i] = points_on(blades[i], poses[i], step_m); });
  Points points;
  points.blade_begin.push_back(0);
  for (const auto& some : on_blade) append(some, points);
  points.side_m.resize(points.size());
  points.across_m.resize(points.size());
  points.vein.resize(points.size());
  points.rest_area_m2 = points.area_m2;
  points.albedo.assign(points.size(), snow_albedo);
  points.transmittance.resize(points.size());
  points.specular.resize(points.size());
  return points;
}

}  // namespace wold::grass
