#include "cloud/volume.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloud/box_filter.h"
#include "cloud/cumulus_column.h"
#include "cloud/diffuse_light.h"
#include "cloud/optical_sweep.h"
#include "cloud/scattering.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::cloud {
namespace {

using std::numbers::pi;

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

/// As high as the sun has to stand for the box.
glm::dvec3 direction_to_sun(const VoxelBox& box, glm::dvec3 to_sun) {
  if (box.repeats) to_sun.z = std::max(to_sun.z, lowest_sun_sine);
  return glm::normalize(to_sun);
}

/// The volume as diffuse_light() wants it. depth: towards the sun.
ScatteringBox scattering_box(const CloudVolume& volume, const std::vector<float>& depth,
                             const CloudLight& light) {
  const double g = volume.asymmetry, leaves_peak = 1.0 - g * g;
  ScatteringBox scattering{
      volume.box,
      std::vector<float>(depth.size()),
      std::vector<float>(depth.size()),
      g / (1.0 + g),
      light.sun_irradiance,
      light.sun_direction,
      light.surroundings ? arriving_radiance(light.surroundings) : ArrivingRadiance{}};
  parallel_for_blocks(depth.size(), [&](std::size_t i) {
    scattering.extinction_per_m[i] =
        static_cast<float>(leaves_peak * double{volume.extinction_per_m[i]});
    scattering.sunlight[i] = static_cast<float>(math::exp(-leaves_peak * double{depth[i]}));
  });
  return scattering;
}

glm::dvec3 centre_m(const VoxelBox& box, int x, int y, int z) {
  return box.corner_m + (glm::dvec3(x, y, z) + 0.5) * box.voxel_m;
}

/// Radiance that droplets send to the eye of light that left the forward peak, which is `peak` of
/// what they scatter: what comes from behind goes on in it.
std::vector<glm::vec3> diffuse_source(const ScatteringBox& scattering, double peak,
                                      const CloudLight& light) {
  const VoxelBox& box = scattering.box;
  const std::vector<LightMoments> diffuse = diffuse_light(scattering);
  std::vector<glm::vec3> source =
      light_to_eye(scattering, diffuse, light.eye_m, light.surroundings);
  const auto stays = static_cast<float>(peak),
             times = static_cast<float>(3.0 * scattering.asymmetry);
  parallel_for(source.size() / static_cast<std::size_t>(box.voxels.x), [&](std::size_t row) {
    const int y = static_cast<int>(row) % box.voxels.y, z = static_cast<int>(row) / box.voxels.y;
    for (int x = 0; x < box.voxels.x; ++x) {
      const std::size_t i = box.index({x, y, z});
      const glm::vec3 to_eye(glm::normalize(light.eye_m - centre_m(box, x, y, z)));
      const glm::vec4 left = diffuse[i].mean + times * (diffuse[i].along(to_eye) - diffuse[i].mean);
      source[i] = stays * source[i] + (1.0F - stays) * glm::vec3(left);
    }
  });
  return source;
}

/// Source radiance per unit of the sun's irradiance: light that still goes roughly its way, and the
/// rest of the fluxes. cosine: between the sun's light and that to the eye.
double sun_source(const ForwardTable& forward, double asymmetry, double before, double behind,
                  double cosine) {
  TwoStream rest = two_stream(asymmetry, before, behind);
  rest.onward -= in_forward_peak(asymmetry, before);
  return forward.at(before, cosine) + radiance_of(rest, cosine);
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
  volume.extinction_per_m.resize(volume.box.count());
  const double droplets = droplets_per_seen(layer);
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
      fill_column(volume, billows, droplets * depth, top_m(layer, neighbours / layer.seen_depth),
                  place,
                  &volume.extinction_per_m[y * static_cast<std::size_t>(voxels.x) +
                                           static_cast<std::size_t>(x)],
                  plane);
    }
  });
  return volume;
}

CloudLight cloud_light(const light::Daylight& day, double height_m, const glm::dvec3& eye_m) {
  const glm::vec3 of_ground = day.level_irradiance() * static_cast<float>(ground_albedo);
  return {day.sun_direction(),
          day.sun_irradiance_at(height_m),
          day.sky_irradiance(),
          of_ground,
          eye_m,
          [day, of_ground](const glm::dvec3& direction) {
            return direction.z > 0.0 ? day.sky_radiance(direction)
                                     : of_ground / std::numbers::pi_v<float>;
          }};
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
  const double g = volume.asymmetry;
  const std::vector<float> depth =
      depth_towards(box, volume.extinction_per_m, direction_to_sun(box, light.sun_direction));
  const ScatteringBox coarse = halved(scattering_box(volume, depth, light));
  const std::vector<glm::vec3> diffuse = diffuse_source(coarse, g * g, light);
  const ForwardTable peak(peak_source, g);
  std::vector<glm::vec3> source(box.count());
  const auto rows = static_cast<std::size_t>(box.voxels.y) * static_cast<std::size_t>(box.voxels.z);
  parallel_for(rows, [&](std::size_t row) {
    const int y = static_cast<int>(row % static_cast<std::size_t>(box.voxels.y));
    const int z = static_cast<int>(row / static_cast<std::size_t>(box.voxels.y));
    for (int x = 0; x < box.voxels.x; ++x) {
      const std::size_t i = box.index({x, y, z});
      const glm::dvec3 from_eye = glm::normalize(centre_m(box, x, y, z) - light.eye_m);
      const double sun = peak.at(double{depth[i]}, glm::dot(from_eye, light.sun_direction));
      source[i] = static_cast<float>(sun) * light.sun_irradiance;
      const CoarseNeighbours around(coarse.box, {x, y, z});
      for (std::size_t j = 0; j < 8; ++j)
        source[i] += around.weights[j] * diffuse[around.voxels[j]];
      source[i] = glm::max(source[i], 0.0F);
    }
  });
  return source;
}

}  // namespace wold::cloud
