#include "grass/texel/visible.h"

#include <numeric>

namespace wold::grass {

float faintest_density(const TexelShape& shape) {
  constexpr double faintest_depth = 0.02;
  return static_cast<float>(faintest_depth / shape.voxel_m);
}

std::vector<std::uint32_t> visible_voxels(const std::vector<float>& density,
                                          const TexelShape& shape) {
  const float min = faintest_density(shape);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < density.size(); ++i)
    if (density[i] >= min) kept.push_back(i);
  if (!kept.empty()) return kept;
  kept.resize(density.size());
  std::iota(kept.begin(), kept.end(), 0U);
  return kept;
}

}  // namespace wold::grass
