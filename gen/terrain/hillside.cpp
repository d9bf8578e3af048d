#include "terrain/hillside.h"

#include <cmath>
#include <numbers>

#include "core/noise.h"
#include "core/parallel.h"
#include "core/random.h"
#include "terrain/erosion.h"

namespace wold::terrain {
namespace {

constexpr double crest_share = 0.72;
constexpr double side_fall_share = 0.25;  // of the hill's height, at the east and west edges
constexpr double creep_m2 = 0.1;          // leaves 2 % of waves of 1 m, 64 % of 3 m

/// The hill without relief: u east and v north across the square, both in [0, 1].
double hill_m(double u, double v, double height_m) {
  const double rise = std::sin(0.5 * std::numbers::pi * v / crest_share);
  const double sideways = 2.0 * u - 1.0;
  return height_m * rise * rise * (1.0 - side_fall_share * std::pow(sideways, 4));
}

}  // namespace

Heightfield make_hillside(const scene::Terrain& terrain, std::uint64_t seed) {
  GroundMap<double> heights_m(terrain.samples, terrain.size_m);
  const Fbm relief{random_bits({seed, key_of("terrain"), 0, key_of("relief")}), terrain.octaves,
                   terrain.roughness};
  parallel_for(static_cast<std::size_t>(terrain.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < terrain.samples; ++i) {
      const glm::dvec2 at_m = glm::dvec2(i, j) * heights_m.step_m();
      const glm::dvec2 uv = at_m / terrain.size_m;
      heights_m.at(i, j) = hill_m(uv.x, uv.y, terrain.hill_height_m) +
                           terrain.relief_m * fbm(at_m / terrain.relief_feature_m, relief);
    }
  });
  slide(heights_m, terrain.talus_deg, terrain.erosion_steps);
  creep(heights_m, creep_m2);
  Heightfield result(terrain.samples, terrain.size_m);
  for (std::size_t k = 0; k < result.values().size(); ++k)
    result.values()[k] = static_cast<float>(heights_m.values()[k]);
  return result;
}

}  // namespace wold::terrain
