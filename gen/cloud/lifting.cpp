#include "cloud/lifting.h"

#include <algorithm>
#include <cmath>

#include "cloud/box_filter.h"
#include "cloud/cumulus_column.h"
#include "cloud/heaps.h"
#include "core/elementary.h"
#include "core/parallel.h"

namespace wold::cloud {
namespace {

/// Fills a column from its lowest voxel's centre up so that its optical depth is `depth`; what is
/// lower than a voxel is in the first.
void fill_column(const CloudVolume& volume, const Billows& billows, double depth, double top_m,
                 glm::dvec3 centre_m, float* lowest, std::size_t stride) {
  const double step_m = volume.box.voxel_m.z;
  const int voxels = std::min(volume.box.voxels.z, static_cast<int>(std::ceil(top_m / step_m)));
  double sum = 0.0;
  for (int z = 0; z < voxels; ++z, centre_m.z += step_m) {
    const double t = (z + 0.5) * step_m / top_m;
    const double profile = column_profile(t);
    const double left = profile > 0.0 ? eroded(profile, t, billows.at(centre_m)) : 0.0;
    lowest[static_cast<std::size_t>(z) * stride] = static_cast<float>(left);
    sum += left;
  }
  if (sum <= 0.0) {
    *lowest = static_cast<float>(depth / step_m);
    return;
  }
  const auto scale = static_cast<float>(depth / (sum * step_m));
  for (int z = 0; z < voxels; ++z) lowest[static_cast<std::size_t>(z) * stride] *= scale;
}

/// Vertical optical depth of every column.
PeriodicMap<float> depth_map(const LayerState& state, double pixel_m, const VoxelBox& box) {
  PeriodicMap<float> depths(box.voxels.x, box.voxels.y);
  parallel_for(static_cast<std::size_t>(box.voxels.y), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < box.voxels.x; ++x)
      depths.at(x, y) =
          static_cast<float>(optical_depth_at(state, pixel_m, box.centre_m({x, y, 0})));
  });
  return depths;
}

/// Of the droplets, what leaves of the densest place's opacity what [Wang2010]'s events do.
double depth_of_alpha(const LayerState& state) {
  if (!state.moment.amount_is_alpha) return 1.0;
  const double depth = state.layer->seen_depth;
  return -math::log1p(state.moment.amount * math::expm1(-depth)) / depth;
}

/// Every column has the optical depth of the layer there.
void fill_by_columns(const LayerState& state, double pixel_m, CloudVolume& volume) {
  const Layer& layer = *state.layer;
  const glm::ivec3& voxels = volume.box.voxels;
  const double droplets = droplets_per_seen(layer);
  const PeriodicMap<float> depths = depth_map(state, pixel_m, volume.box);
  const PeriodicMap<float> smooth =
      smoothed_for_tops(depths, layer.thickness_m / volume.box.voxel_m.x);
  const Billows billows(state);
  const auto plane = static_cast<std::size_t>(voxels.x) * static_cast<std::size_t>(voxels.y);
  parallel_for(static_cast<std::size_t>(voxels.y), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < voxels.x; ++x) {
      const double depth{depths.at(x, y)};
      if (depth <= 0.0) continue;
      const double neighbours{smooth.at(x, y)};
      fill_column(volume, billows, droplets * depth, top_m(layer, neighbours / layer.seen_depth),
                  volume.box.centre_m({x, y, 0}),
                  &volume.extinction_per_m[volume.box.index({x, y, 0})], plane);
    }
  });
}

/// Droplets in the heaps that lines of sight see (heaps.h), as far as voxels hold their heads.
void fill_with_heaps(const LayerState& state, double pixel_m, CloudVolume& volume) {
  const Heaps heaps(state, sheets_of(state, pixel_m));
  const Layer& layer = *state.layer;
  const VoxelBox& box = volume.box;
  constexpr double soft = 0.06;  // of the field: some metres
  const double footprint_m = 0.5 * std::max({box.voxel_m.x, box.voxel_m.y, box.voxel_m.z});
  const double droplets_per_m = depth_of_alpha(state) * layer.droplets.extinction_per_m;
  parallel_for(static_cast<std::size_t>(box.voxels.y), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < box.voxels.x; ++x) {
      const double top_m = heaps.top_m(glm::dvec2(box.centre_m({x, y, 0})));
      const int filled = std::min(static_cast<int>(std::ceil(top_m / box.voxel_m.z)), box.voxels.z);
      for (int z = 0; z < filled; ++z)
        volume.extinction_per_m[box.index({x, y, z})] = static_cast<float>(
            droplets_per_m *
            std::clamp(heaps.field(box.centre_m({x, y, z}), footprint_m) / soft, 0.0, 1.0));
    }
  });
}

bool is_period(const LayerState& state, const glm::dvec2& side_m) {
  const glm::dvec2 difference = glm::abs(side_m - state.layer->period_m);
  return std::max(difference.x, difference.y) < 1e-6 * side_m.x;
}

}  // namespace

CloudVolume lifted(const LayerState& state, double pixel_m, const glm::dvec2& south_west_m,
                   const glm::dvec2& side_m, const glm::ivec3& voxels) {
  const Layer& layer = *state.layer;
  CloudVolume volume;
  volume.box.corner_m = glm::dvec3(south_west_m, layer.base_m);
  volume.box.voxel_m = glm::dvec3(side_m, layer.thickness_m) / glm::dvec3(voxels);
  volume.box.voxels = voxels;
  volume.box.repeats = is_period(state, side_m);
  volume.asymmetry = layer.droplets.asymmetry;
  volume.extinction_per_m.resize(volume.box.count());
  if (stands_in_heaps(layer))
    fill_with_heaps(state, pixel_m, volume);
  else
    fill_by_columns(state, pixel_m, volume);
  return volume;
}

}  // namespace wold::cloud
