#include "grass/texel/mingle.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "grass/texel/texel_builder.h"

namespace wold::grass {
namespace {

/// The voxels of all samples, each of which stays where it is.
class SampleContributions {
 public:
  explicit SampleContributions(std::span<const Texel> samples) : samples_(samples) {
    std::size_t voxels = 0;
    for (const Texel& sample : samples) {
      first_.push_back(voxels);
      voxels += sample.size();
    }
  }

  template <class Visit>
  void each_in_slice(int z, const Visit& visit) const {
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      const Texel& sample = samples_[k];
      const std::uint32_t begin = sample.shape.linear(0, 0, z);
      const std::uint32_t end = sample.shape.linear(0, 0, z + 1);
      const auto& voxel = sample.voxel;
      auto i = static_cast<std::size_t>(std::lower_bound(voxel.begin(), voxel.end(), begin) -
                                        voxel.begin());
      for (; i < voxel.size() && voxel[i] < end; ++i) {
        const VoxelWeight whole{voxel[i] - begin, area_m2(sample, i)};
        visit(first_[k] + i, std::span<const VoxelWeight, 1>(&whole, 1));
      }
    }
  }

  Moments moments(std::size_t which) const {
    const auto after = std::upper_bound(first_.begin(), first_.end(), which);
    const auto k = static_cast<std::size_t>(after - first_.begin()) - 1;
    const Texel& sample = samples_[k];
    const std::size_t voxel = which - first_[k];
    return {sample.tangent[voxel], sample.normal[voxel], sample.albedo[voxel],
            sample.transmittance[voxel], sample.specular[voxel]};
  }

 private:
  static float area_m2(const Texel& sample, std::size_t voxel) {
    return static_cast<float>(double{sample.density[voxel]} * sample.shape.voxel_volume_m3());
  }

  std::span<const Texel> samples_;
  std::vector<std::size_t> first_;  ///< number of each sample's first voxel
};

void check_shapes(std::span<const Texel> samples) {
  if (samples.empty()) throw std::invalid_argument("no samples to mingle");
  const TexelShape& shape = samples[0].shape;
  for (const Texel& sample : samples)
    if (sample.shape != shape)
      throw std::invalid_argument(fmt::format(
          "samples to mingle have {} x {} voxels of {} m and {} x {} of {} m, side by height",
          shape.side, shape.height, shape.voxel_m, sample.shape.side, sample.shape.height,
          sample.shape.voxel_m));
}

}  // namespace

Texel mingle(std::span<const Texel> samples) {
  check_shapes(samples);
  double area_m2 = 0.0;
  for (const Texel& sample : samples) area_m2 += sample.area_m2();
  return build_texel(samples[0].shape, SampleContributions(samples), area_m2);
}

}  // namespace wold::grass
