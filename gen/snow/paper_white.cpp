#include "snow/paper_white.h"

#include <cmath>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::snow {

FactorMap paper_white(double size_m, double gamma, int samples, std::uint64_t seed) {
  constexpr double max_dots = 4.0;  // in a texel, at gamma = 1
  const double chance_of_hit = -math::expm1(-max_dots * gamma);
  FactorMap white(samples, size_m);
  parallel_for_blocks(white.values().size(), [&](std::size_t texel) {
    const RandomKey key{seed, key_of("snow cover"), texel, key_of("dot")};
    white.values()[texel] = random_uniform(key) < chance_of_hit ? 1.0F : 0.0F;
  });
  return white;
}

}  // namespace wold::snow
