#include "terrain/fractal_relief.h"

#include "core/noise.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::terrain {

void add_fractal_relief(GroundMap<double>& heights_m, const scene::Terrain& terrain,
                        std::uint64_t seed, double deviation_m, double feature_m) {
  const Fbm relief{random_bits({seed, key_of("terrain"), 0, key_of("relief")}), terrain.octaves,
                   terrain.roughness};
  parallel_for(static_cast<std::size_t>(heights_m.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < heights_m.samples(); ++i) {
      const glm::dvec2 at_m = glm::dvec2(i, j) * heights_m.step_m();
      heights_m.at(i, j) += deviation_m * relief.at(at_m / feature_m);
    }
  });
}

}  // namespace wold::terrain
