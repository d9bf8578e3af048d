#include "grass/coverage.h"

#include <algorithm>
#include <cstdint>

#include "grass/silhouette.h"

namespace wold::grass {

double blade_transmittance(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                           double patch_m, const glm::dvec3& direction) {
  constexpr int side = 512;
  constexpr int segments = 14;
  std::vector<std::uint8_t> hit(static_cast<std::size_t>(side) * side, 0);
  for (std::size_t i = 0; i < blades.size(); ++i)
    each_strip(
        blades[i], poses[i], segments, patch_m, glm::vec3(direction), [&](const Strip& strip) {
          each_covered_pixel(side, strip, [&](std::size_t pixel, double) { hit[pixel] = 1; });
        });
  return static_cast<double>(std::count(hit.begin(), hit.end(), 0)) /
         static_cast<double>(hit.size());
}

}  // namespace wold::grass
