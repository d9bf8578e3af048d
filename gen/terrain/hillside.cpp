#include "terrain/hillside.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/elementary.h"
#include "terrain/creep.h"
#include "terrain/erosion.h"
#include "terrain/fractal_relief.h"
#include "terrain/streams.h"

namespace wold::terrain {
namespace {

constexpr double crest_fraction = 0.72;
constexpr double side_fall_fraction = 0.25;  // of the hill's height, at the east and west edges

/// The hill without relief: u east and v north across the square, both in [0, 1].
double hill_m(double u, double v, double height_m) {
  const double rise = math::sin(0.5 * std::numbers::pi * v / crest_fraction);
  const double sideways = 2.0 * u - 1.0;
  return height_m * rise * rise * (1.0 - side_fall_fraction * math::pow(sideways, 4));
}

}  // namespace

Heightfield make_hillside(const scene::Terrain& terrain, std::uint64_t seed) {
  GroundMap<double> heights_m(terrain.samples, terrain.size_m);
  for (int j = 0; j < terrain.samples; ++j)
    for (int i = 0; i < terrain.samples; ++i) {
      const glm::dvec2 uv = glm::dvec2(i, j) * heights_m.step_m() / terrain.size_m;
      heights_m.at(i, j) = hill_m(uv.x, uv.y, terrain.hill_height_m);
    }
  add_fractal_relief(heights_m, terrain, seed, terrain.relief_m, terrain.relief_feature_m);
  carve(heights_m, {.reach = terrain.streams, .source_fraction = 3e-4, .steps = 6});
  slide(heights_m, terrain.talus_deg, terrain.erosion_steps);
  return crept(std::move(heights_m));
}

}  // namespace wold::terrain
