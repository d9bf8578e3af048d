#include "grass/texel/coverage.h"

#include <algorithm>
#include <cstdint>

#include "grass/geometry/silhouette.h"

namespace wold::grass {

double blade_transmittance(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                           double patch_m, const std::vector<glm::dvec3>& directions) {
  constexpr int side = 512;
  constexpr int segments = 14;
  const std::vector<Piece> pieces = pieces_of(blades, poses, segments);
  double sum = 0.0;
  for (const glm::dvec3& direction : directions) {
    std::vector<std::uint8_t> hit(static_cast<std::size_t>(side) * side, 0);
    for (const Piece& piece : pieces)
      each_covered_pixel(side, strip_of(piece, patch_m, glm::vec3(direction)),
                         [&](std::size_t pixel, double) { hit[pixel] = 1; });
    sum += static_cast<double>(std::count(hit.begin(), hit.end(), 0)) /
           static_cast<double>(hit.size());
  }
  return sum / static_cast<double>(directions.size());
}

}  // namespace wold::grass
