#include "grass/texel/texel_builder.h"

#include <array>
#include <functional>

namespace wold::grass {

double area_m2_of(const std::vector<KeptSlice>& slices) {
  double sum = 0.0;
  for (const KeptSlice& slice : slices) sum += slice.area_m2;
  return sum;
}

Texel texel_for(const TexelShape& shape, const std::vector<KeptSlice>& slices) {
  const std::size_t size = slices.empty() ? 0 : slices.back().begin + slices.back().voxels.size();
  Texel texel;
  texel.shape = shape;
  // New memory is slow when it is touched for the first time.
  const std::array<std::function<void()>, 7> resize{
      [&] { texel.tangent.resize(size); },       [&] { texel.normal.resize(size); },
      [&] { texel.transmittance.resize(size); }, [&] { texel.albedo.resize(size); },
      [&] { texel.voxel.resize(size); },         [&] { texel.specular.resize(size); },
      [&] { texel.density.resize(size); }};
  parallel_for(resize.size(), [&](std::size_t i) { resize[i](); });
  return texel;
}

void write_densities(const KeptSlice& slice, int z, float per_area, Texel& texel) {
  const std::uint32_t first = texel.shape.linear(0, 0, z);
  for (std::size_t i = 0; i < slice.voxels.size(); ++i) {
    texel.voxel[slice.begin + i] = first + slice.voxels[i].ground;
    texel.density[slice.begin + i] = per_area * slice.voxels[i].area_m2;
  }
}

}  // namespace wold::grass
