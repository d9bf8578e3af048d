#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"

/// The paper's snow on the ground (section 3): the terrain's texture whitens under growing noise,
/// its shape stays as it is.
namespace wold::snow {

/// A triangle of the terrain.
struct Facet {
  std::array<glm::dvec3, 3> corners_m;  ///< counter-clockwise seen from above: A, B, C
  double texture_area = 0.0;            ///< of the square of side 1 that the texture is
};

/// Angle of the facet's normal AB x BC against up, degrees in [0, 180] (steps 1 and 2; the printed
/// formula has dot products where a cross product is meant). 0 for a facet without area, which has
/// no normal.
double angle_deg(const Facet& facet);

/// phi, 1/m2: texture area over world area (step 4); 0 for a facet without area.
double texture_per_m2(const Facet& facet);

/// How strongly noise perturbs the texture of a facet, 1/m2: gamma phi, or 0 if it is turned
/// further than 90 degrees or has no area: no snow lies there (steps 3 and 5).
double noise_per_m2(const Facet& facet, double gamma);

/// The terrain as squares of two triangles each, of about `facet_m2` m2 of the map, one square at
/// least and no more than the terrain has. The texture lies on it from above.
class Facets {
 public:
  Facets(const Heightfield& terrain, double facet_m2);
  int along_side() const { return along_side_; }
  /// Of the square (i, j), 0 <= i, j < along_side(); half 0 is the south-eastern one, 1 the other.
  const Facet& at(int i, int j, int half) const {
    const auto row = static_cast<std::size_t>(j) * static_cast<std::size_t>(along_side_);
    return facets_[2 * (row + static_cast<std::size_t>(i)) + static_cast<std::size_t>(half)];
  }

 private:
  int along_side_;
  std::vector<Facet> facets_;
};

/// Where the texture is white, 0 or 1, on a map of `samples` >= 2 along a side, when the noise has
/// the strength gamma in [0, 1] (steps 5 to 7). Noise is dots of one texel at random places; a
/// facet's strength is their number per m2 of ground, in units of four per texel of the whole
/// texture. So each texel is hit 4 gamma times in the mean, by Poisson's law, whatever its facet's
/// phi, and 1 - exp(-4 gamma) of the ground is white: 98 % at last. White texels stay white while
/// gamma grows.
FactorMap paper_white(const Facets& facets, double size_m, double gamma, int samples,
                      std::uint64_t seed);

}  // namespace wold::snow
