#include "grass/coverage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace wold::grass {
namespace {

constexpr int mask_side = 512;

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

/// Ground mask of a patch; coordinates in patches, wrapping.
class Mask {
 public:
  Mask() : hit_(static_cast<std::size_t>(mask_side) * mask_side, 0) {}

  /// Covers the pixels whose centres lie in the parallelogram from a - half to b + half; centres,
  /// because covering all that it touches would widen every blade by a pixel.
  void cover(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& half) {
    const glm::dvec2 along = b - a;
    const double area = along.x * half.y - along.y * half.x;
    if (area == 0.0) return;
    const glm::dvec2 reach = (glm::abs(along) + 2.0 * glm::abs(half)) * (mask_side / 2.0);
    const glm::dvec2 middle = (a + b) * (mask_side / 2.0);
    const glm::dvec2 first = glm::ceil(middle - reach - 0.5);
    const glm::dvec2 end = glm::floor(middle + reach + 0.5);
    constexpr double pixel = 1.0 / mask_side;
    for (auto y = static_cast<int>(first.y); y < static_cast<int>(end.y); ++y) {
      // Along the row, both coordinates in the parallelogram are linear in x.
      const glm::dvec2 from_a = glm::dvec2(0.5 * pixel, (y + 0.5) * pixel) - a;
      Run run(first.x, end.x);
      run.keep((from_a.x * half.y - from_a.y * half.x) / area, pixel * half.y / area, 0.0, 1.0);
      run.keep((along.x * from_a.y - along.y * from_a.x) / area, -pixel * along.y / area, -1.0,
               1.0);
      for (int x = run.first(); x < run.end(); ++x) set(x, y);
    }
  }
  double uncovered() const {
    return static_cast<double>(std::count(hit_.begin(), hit_.end(), 0)) /
           static_cast<double>(hit_.size());
  }

 private:
  void set(int x, int y) {
    const auto wrapped = [](int i) {
      const int rest = i % mask_side;
      return static_cast<std::size_t>(rest < 0 ? rest + mask_side : rest);
    };
    hit_[wrapped(y) * mask_side + wrapped(x)] = 1;
  }
  std::vector<std::uint8_t> hit_;
};

void cover_blade(Mask& mask, const Blade& blade, const BladePose& pose, double patch_m,
                 const glm::vec3& direction) {
  constexpr int segments = 14;
  const float arc_m = blade.length_m * pose.length_scale;
  const glm::vec2 slope = glm::vec2(direction) / direction.z;
  const auto on_ground = [&](const glm::vec3& place_m) {
    return (glm::vec2(place_m) - place_m.z * slope) / static_cast<float>(patch_m);
  };
  const auto place = [&](const AxisPoint& axis) {
    return glm::vec3(blade.root_m + blade.heading * axis.position_m.x, axis.position_m.y);
  };
  AxisPoint from = axis_point(blade, pose, 0.0F);
  for (int i = 1; i <= segments; ++i) {
    const float end = static_cast<float>(i) / segments;
    const AxisPoint to = axis_point(blade, pose, arc_m * end);
    const glm::vec3 tangent(blade.heading * to.tangent.x, to.tangent.y);
    const glm::vec3 across = glm::cross(tangent, direction);
    const float sine = std::max(glm::length(across), 1e-3F);
    const float radius = blade.radius_m * pose.mesophyll_width * (1.0F - end + 0.5F / segments);
    mask.cover(on_ground(place(from)), on_ground(place(to)), on_ground(across / sine * radius));
    from = to;
  }
}

}  // namespace

double blade_transmittance(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                           double patch_m, const glm::dvec3& direction) {
  Mask mask;
  for (std::size_t i = 0; i < blades.size(); ++i)
    cover_blade(mask, blades[i], poses[i], patch_m, glm::vec3(direction));
  return mask.uncovered();
}

}  // namespace wold::grass
