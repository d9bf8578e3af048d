#include "terrain/ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/elementary.h"
#include "terrain/elevation.h"
#include "terrain/erosion.h"
#include "terrain/fractal_relief.h"
#include "terrain/hillside.h"
#include "terrain/mountain.h"

namespace wold::terrain {
namespace {

Heightfield real_place(const scene::Terrain& terrain, std::uint64_t seed) {
  Elevation place = read_elevation(terrain);
  const double feature_m = std::min(place.cell_m, terrain.relief_feature_m);
  const double fraction = math::pow(feature_m / terrain.relief_feature_m, terrain.roughness);
  add_fractal_relief(place.heights_m, terrain, seed, terrain.relief_m * fraction, feature_m);
  return crept(std::move(place.heights_m));
}

}  // namespace

Heightfield make_ground(const scene::Terrain& terrain, std::uint64_t seed) {
  if (!terrain.elevation.empty()) return real_place(terrain, seed);
  return terrain.shape == scene::TerrainShape::mountain ? make_mountain(terrain, seed)
                                                        : make_hillside(terrain, seed);
}

}  // namespace wold::terrain
