#include "cloud/volume.h"

#include <algorithm>
#include <cmath>

#include "cloud/box_filter.h"
#include "cloud/cumulus_column.h"
#include "cloud/optical_sweep.h"
#include "cloud/scattering.h"
#include "core/parallel.h"
#include "core/random.h"

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

bool is_period(const LayerState& state, const glm::dvec2& side_m) {
  const glm::dvec2 difference = glm::abs(side_m - state.layer->period_m);
  return std::max(difference.x, difference.y) < 1e-6 * side_m.x;
}

/// Optical depths of the droplets, from a voxel out of the cloud.
struct Depths {
  std::vector<float> to_sun, from_sun, up, down;
};

Depths depths_of(const CloudVolume& volume, const glm::dvec3& sun_direction) {
  glm::dvec3 to_sun = sun_direction;
  to_sun.z = std::max(to_sun.z, lowest_sun_sine);
  to_sun = glm::normalize(to_sun);
  const auto towards = [&](const glm::dvec3& direction) {
    return depth_towards(volume.box, volume.extinction_per_m, direction);
  };
  return {towards(to_sun), towards(-to_sun), towards({0.0, 0.0, 1.0}), towards({0.0, 0.0, -1.0})};
}

/// Source radiance per unit of the sun's irradiance: light that still goes roughly its way, and the
/// rest of the fluxes. cosine: between the sun's light and that to the eye.
double sun_source(const ForwardTable& forward, double asymmetry, double before, double behind,
                  double cosine) {
  TwoStream rest = two_stream(asymmetry, before, behind);
  rest.onward -= in_forward_peak(asymmetry, before);
  return forward.at(before, cosine) + radiance_of(rest, cosine);
}

glm::dvec3 centre_m(const VoxelBox& box, int x, int y, int z) {
  return box.corner_m + (glm::dvec3(x, y, z) + 0.5) * box.voxel_m;
}

/// Vertical optical depth of every column.
PeriodicMap<float> depth_map(const LayerState& state, double pixel_m, const VoxelBox& box) {
  PeriodicMap<float> depths(box.voxels.x, box.voxels.y);
  parallel_for(static_cast<std::size_t>(box.voxels.y), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < box.voxels.x; ++x)
      depths.at(x, y) =
          static_cast<float>(optical_depth_at(state, pixel_m, centre_m(box, x, y, 0)));
  });
  return depths;
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
  volume.droplets_per_seen = droplets_per_seen(layer);
  volume.extinction_per_m.resize(volume.box.count());
  const PeriodicMap<float> depths = depth_map(state, pixel_m, volume.box);
  const PeriodicMap<float> smooth =
      smoothed_for_tops(depths, layer.thickness_m / volume.box.voxel_m.x);
  const Billows billows(state);
  const auto plane = static_cast<std::size_t>(voxels.x) * static_cast<std::size_t>(voxels.y);
  parallel_for(static_cast<std::size_t>(voxels.y), [&](std::size_t y) {
    for (int x = 0; x < voxels.x; ++x) {
      const glm::dvec3 place = centre_m(volume.box, x, static_cast<int>(y), 0);
      const double depth{depths.at(x, static_cast<int>(y))};
      if (depth <= 0.0) continue;
      const double neighbours{smooth.at(x, static_cast<int>(y))};
      fill_column(volume, billows, depth, top_m(layer, neighbours / layer.seen_depth), place,
                  &volume.extinction_per_m[y * static_cast<std::size_t>(voxels.x) +
                                           static_cast<std::size_t>(x)],
                  plane);
    }
  });
  return volume;
}

CloudLight cloud_light(const light::Daylight& day, double height_m, const glm::dvec3& eye_m) {
  return {day.sun_direction(), day.sun_irradiance_at(height_m), day.sky_irradiance(),
          day.level_irradiance() * static_cast<float>(ground_albedo), eye_m};
}

glm::vec3 source_at(const ForwardTable& forward, double asymmetry, const DepthsAround& depths,
                    const glm::dvec3& from_eye, const CloudLight& light) {
  const double sun = sun_source(forward, asymmetry, depths.to_sun, depths.from_sun,
                                glm::dot(from_eye, light.sun_direction));
  const double sky = radiance_of(two_stream(asymmetry, depths.up, depths.down), from_eye.z);
  const double ground = radiance_of(two_stream(asymmetry, depths.down, depths.up), -from_eye.z);
  return static_cast<float>(sun) * light.sun_irradiance +
         static_cast<float>(sky) * light.sky_irradiance +
         static_cast<float>(ground) * light.ground_irradiance;
}

std::vector<glm::vec3> source_radiance(const CloudVolume& volume, const CloudLight& light) {
  const VoxelBox& box = volume.box;
  const Depths depths = depths_of(volume, light.sun_direction);
  const double k = volume.droplets_per_seen, g = volume.asymmetry;
  const ForwardTable forward(forward_source, g);
  std::vector<glm::vec3> source(box.count());
  const auto rows = static_cast<std::size_t>(box.voxels.y) * static_cast<std::size_t>(box.voxels.z);
  parallel_for(rows, [&](std::size_t row) {
    const int y = static_cast<int>(row % static_cast<std::size_t>(box.voxels.y));
    const int z = static_cast<int>(row / static_cast<std::size_t>(box.voxels.y));
    for (int x = 0; x < box.voxels.x; ++x) {
      const std::size_t i =
          row * static_cast<std::size_t>(box.voxels.x) + static_cast<std::size_t>(x);
      const DepthsAround around = {k * depths.to_sun[i], k * depths.from_sun[i], k * depths.up[i],
                                   k * depths.down[i]};
      source[i] = source_at(forward, g, around,
                            glm::normalize(centre_m(box, x, y, z) - light.eye_m), light);
    }
  });
  return source;
}

}  // namespace wold::cloud
