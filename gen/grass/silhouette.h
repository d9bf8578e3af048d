#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "grass/axis.h"
#include "grass/snow_ridge.h"

/// Silhouettes of bent blades, projected along a direction onto the plane of the ground and drawn
/// into a square of pixels that tiles like the patch.
namespace wold::grass {

/// A straight piece of a blade, or of the snow on it, on the ground's plane, in patches: the
/// parallelogram from a - half to b + half.
struct Strip {
  glm::dvec2 a, b, half;
  float along_a, along_b;    ///< place on the blade: 0 root, 1 tip
  float height_a, height_b;  ///< of the axis above the ground, m
  bool snow = false;
};

/// Where a ray along `direction` (towards the eye, z > 0) through a place meets the ground's plane,
/// in patches.
inline glm::dvec2 on_ground(const glm::vec3& place_m, const glm::vec3& direction, double patch_m) {
  const glm::vec2 slope = glm::vec2(direction) / direction.z;
  return glm::dvec2((glm::vec2(place_m) - place_m.z * slope) / static_cast<float>(patch_m));
}

/// Calls visit(strip) for the pieces of the ridge of snow on a blade.
template <class Visit>
void each_ridge_strip(const Blade& blade, const BladePose& pose, double patch_m,
                      const glm::vec3& direction, const Visit& visit) {
  constexpr int segments = 48;
  const float length_m = blade.length_m * pose.length_scale;
  const glm::vec3 level(-blade.heading.y, blade.heading.x, 0.0F);
  const auto place = [&](const glm::vec2& in_plane_m) {
    return on_ground(glm::vec3(blade.root_m, 0.0F) + from_plane(blade, in_plane_m), direction,
                     patch_m);
  };
  const BladeAxis axis(blade, pose);
  for (int i = 0; i < segments; ++i) {
    const float begin = static_cast<float>(i) / segments;
    const float end = static_cast<float>(i + 1) / segments;
    const float along = 0.5F * (begin + end);
    const AxisPoint at = axis.at(length_m * along);
    const SnowRidge ridge = snow_ridge(blade, pose, along, at);
    if (ridge.half_height_m <= 0.0F) continue;
    const glm::vec3 across = glm::cross(from_plane(blade, at.tangent), direction);
    const glm::vec3 aside = across / std::max(glm::length(across), 1e-3F);
    const float reach_m = std::hypot(
        ridge.half_width_m * glm::dot(aside, level),
        ridge.half_height_m * glm::dot(aside, from_plane(blade, upper_side(at.tangent))));
    const glm::vec2 half_way = 0.5F * length_m / segments * at.tangent;
    const glm::dvec2 half = on_ground(reach_m * aside, direction, patch_m);
    visit(Strip{place(ridge.centre_m - half_way), place(ridge.centre_m + half_way), half, begin,
                end, ridge.centre_m.y - half_way.y, ridge.centre_m.y + half_way.y, true});
  }
}

/// Calls visit(strip) for `segments` pieces of the blade, seen along `direction` (unit, towards the
/// eye, z > 0), and for those of its snow.
template <class Visit>
void each_strip(const Blade& blade, const BladePose& pose, int segments, double patch_m,
                const glm::vec3& direction, const Visit& visit) {
  const float length_m = blade.length_m * pose.length_scale;
  const auto place = [&](const glm::vec3& place_m) {
    return on_ground(place_m, direction, patch_m);
  };
  const BladeAxis axis(blade, pose);
  AxisPoint from = axis.at(0.0F);
  float begin = 0.0F;
  for (int i = 1; i <= segments; ++i) {
    const float end = static_cast<float>(i) / static_cast<float>(segments);
    const AxisPoint to = axis.at(length_m * end);
    const glm::vec3 across = glm::cross(from_plane(blade, to.tangent), direction);
    const float sine = std::max(glm::length(across), 1e-3F);
    const float radius = blade.radius_m * pose.mesophyll_width * (1.0F - 0.5F * (begin + end));
    visit(Strip{place(on_patch_m(blade, from)), place(on_patch_m(blade, to)),
                place(across / sine * radius), begin, end, from.position_m.y, to.position_m.y});
    from = to;
    begin = end;
  }
  if (pose.snow > 0.0F) each_ridge_strip(blade, pose, patch_m, direction, visit);
}

/// The whole numbers x in [first, end) for which linear functions of x lie between bounds.
class Run {
 public:
  Run(double first, double end) : first_(first), end_(end) {}
  /// Keeps x with low <= at_zero + slope x < high.
  void keep(double at_zero, double slope, double low, double high) {
    if (slope == 0.0) {
      if (at_zero < low || at_zero >= high) end_ = first_;
      return;
    }
    const double from = ((slope > 0.0 ? low : high) - at_zero) / slope;
    const double to = ((slope > 0.0 ? high : low) - at_zero) / slope;
    first_ = std::max(first_, std::ceil(from));
    end_ = std::min(end_, std::ceil(to));
  }
  /// Empty when end() <= first().
  int first() const { return static_cast<int>(first_); }
  int end() const { return static_cast<int>(end_); }

 private:
  double first_;
  double end_;
};

/// Calls visit(pixel, t) for the pixels of a side x side square whose centres lie in the strip; t
/// runs from 0 at a to 1 at b. Centres, because taking all that the strip touches would widen every
/// blade by a pixel.
template <class Visit>
void each_covered_pixel(int side, const Strip& strip, const Visit& visit) {
  const auto wrapped = [side](int i) {
    const int rest = i % side;
    return static_cast<std::size_t>(rest < 0 ? rest + side : rest);
  };
  const glm::dvec2 along = strip.b - strip.a;
  const double area = along.x * strip.half.y - along.y * strip.half.x;
  if (area == 0.0) return;
  const glm::dvec2 reach = (glm::abs(along) + 2.0 * glm::abs(strip.half)) * (side / 2.0);
  const glm::dvec2 middle = (strip.a + strip.b) * (side / 2.0);
  const glm::dvec2 first = glm::ceil(middle - reach - 0.5);
  const glm::dvec2 end = glm::floor(middle + reach + 0.5);
  const double pixel = 1.0 / side;
  for (auto y = static_cast<int>(first.y); y < static_cast<int>(end.y); ++y) {
    // Along the row, both coordinates in the parallelogram are linear in x.
    const glm::dvec2 from_a = glm::dvec2(0.5 * pixel, (y + 0.5) * pixel) - strip.a;
    const double t0 = (from_a.x * strip.half.y - from_a.y * strip.half.x) / area;
    const double t_step = pixel * strip.half.y / area;
    Run run(first.x, end.x);
    run.keep(t0, t_step, 0.0, 1.0);
    run.keep((along.x * from_a.y - along.y * from_a.x) / area, -pixel * along.y / area, -1.0, 1.0);
    const std::size_t row = wrapped(y) * static_cast<std::size_t>(side);
    for (int x = run.first(); x < run.end(); ++x) visit(row + wrapped(x), t0 + t_step * x);
  }
}

}  // namespace wold::grass
