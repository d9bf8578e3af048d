#include "grass/coverage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace wold::grass {
namespace {

constexpr int mask_side = 512;

/// Ground mask of a patch; coordinates in patches, wrapping.
class Mask {
 public:
  Mask() : hit_(static_cast<std::size_t>(mask_side) * mask_side, 0) {}

  /// Covers the band from a - half to b + half, sampled at less than a mask pixel.
  void cover(const glm::vec2& a, const glm::vec2& b, const glm::vec2& half) {
    const glm::vec2 along = b - a;
    const int steps = pieces(along);
    const int across = pieces(2.0F * half);
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < across; ++j) {
        const float u = (static_cast<float>(i) + 0.5F) / static_cast<float>(steps);
        const float v = 2.0F * (static_cast<float>(j) + 0.5F) / static_cast<float>(across) - 1.0F;
        set(a + u * along + v * half);
      }
  }
  double uncovered() const {
    return static_cast<double>(std::count(hit_.begin(), hit_.end(), 0)) /
           static_cast<double>(hit_.size());
  }

 private:
  static int pieces(const glm::vec2& way) {
    return std::max(1, static_cast<int>(std::ceil(glm::length(way) * mask_side * 1.2F)));
  }
  void set(const glm::vec2& place) {
    const glm::vec2 tile = place - glm::floor(place);
    const int x = std::min(static_cast<int>(tile.x * mask_side), mask_side - 1);
    const int y = std::min(static_cast<int>(tile.y * mask_side), mask_side - 1);
    hit_[static_cast<std::size_t>(y) * mask_side + static_cast<std::size_t>(x)] = 1;
  }
  std::vector<std::uint8_t> hit_;
};

void cover_blade(Mask& mask, const Blade& blade, const BladePose& pose, double patch_m,
                 const glm::vec3& direction) {
  constexpr int segments = 20;
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
