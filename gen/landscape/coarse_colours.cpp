#include "landscape/coarse_colours.h"

#include <cstddef>

namespace wold::landscape {
namespace {

/// Sums over each voxel: brightness times colour, and brightness.
struct Sums {
  glm::ivec3 voxels{0};
  std::vector<glm::vec4> values;

  explicit Sums(glm::ivec3 size)
      : voxels(size),
        values(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
               static_cast<std::size_t>(size.z)) {}

  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(voxels.y) +
            static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(voxels.x) +
           static_cast<std::size_t>(x);
  }
};

/// Calls visit(index of the voxel, index in the grid of half its resolution) for each voxel.
template <class Visit>
void for_each_voxel(glm::ivec3 voxels, const Sums& coarse, const Visit& visit) {
  std::size_t fine = 0;
  for (int z = 0; z < voxels.z; ++z)
    for (int y = 0; y < voxels.y; ++y)
      for (int x = 0; x < voxels.x; ++x) visit(fine++, coarse.index(x / 2, y / 2, z / 2));
}

Sums sums_of(std::span<const float> brightness, std::span<const glm::vec3> colours,
             glm::ivec3 voxels) {
  Sums sums(glm::ivec3((voxels.x + 1) / 2, (voxels.y + 1) / 2, voxels.z / 2 + 1));
  for_each_voxel(voxels, sums, [&](std::size_t fine, std::size_t coarse) {
    const float weight = brightness[fine];
    if (weight > 0.0F) sums.values[coarse] += weight * glm::vec4(colours[fine], 1.0F);
  });
  return sums;
}

Sums halved(const Sums& fine) {
  Sums sums((fine.voxels + 1) / 2);
  for_each_voxel(fine.voxels, sums,
                 [&](std::size_t from, std::size_t to) { sums.values[to] += fine.values[from]; });
  return sums;
}

/// Gives dark voxels what the coarser grid has there.
void fill_air(Sums& sums, const Sums& coarser) {
  for_each_voxel(sums.voxels, coarser, [&](std::size_t fine, std::size_t coarse) {
    if (!(sums.values[fine].w > 0.0F)) sums.values[fine] = coarser.values[coarse];
  });
}

}  // namespace

ColourGrid coarse_colours(std::span<const float> brightness, std::span<const glm::vec3> colours,
                          glm::ivec3 voxels) {
  std::vector<Sums> grids = {sums_of(brightness, colours, voxels)};
  while (grids.back().voxels != glm::ivec3(1)) grids.push_back(halved(grids.back()));
  for (std::size_t i = grids.size() - 1; i > 0; --i) fill_air(grids[i - 1], grids[i]);
  ColourGrid result{grids.front().voxels, {}};
  result.values.reserve(grids.front().values.size());
  for (const glm::vec4& sum : grids.front().values)
    result.values.push_back(sum.w > 0.0F ? glm::vec3(sum) / sum.w : glm::vec3(0.0F));
  return result;
}

}  // namespace wold::landscape
