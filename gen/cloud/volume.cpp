#include "cloud/volume.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloud/between_voxels.h"
#include "cloud/diffuse_light.h"
#include "cloud/optical_sweep.h"
#include "cloud/scattering.h"
#include "cloud/sunlit.h"
#include "core/elementary.h"
#include "core/parallel.h"

namespace wold::cloud {
namespace {

using std::numbers::pi;

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

/// On voxels twice as large, or as much larger as light shows that left the forward peak: half of
/// its free path.
ScatteringBox coarsened(const ScatteringBox& scattering) {
  constexpr double coarsest_m = 16.0;
  ScatteringBox coarse = halved(scattering);
  const auto side_m = [&] {
    return std::max({coarse.box.voxel_m.x, coarse.box.voxel_m.y, coarse.box.voxel_m.z});
  };
  while (2.0 * side_m() <= coarsest_m) coarse = halved(coarse);
  return coarse;
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
      const glm::vec3 to_eye(glm::normalize(light.eye_m - box.centre_m({x, y, z})));
      const glm::vec4 left = diffuse[i].mean + times * (diffuse[i].along(to_eye) - diffuse[i].mean);
      source[i] = stays * source[i] + (1.0F - stays) * glm::vec3(left);
    }
  });
  return source;
}

/// Radiance, per unit of what falls on their lit side, of streams without what of them still goes
/// roughly the sun's way.
double even_radiance(TwoStream streams, double in_peak, double cosine) {
  streams.onward = std::max(streams.onward - in_peak, 0.0);
  return radiance_of(streams, cosine);
}

/// Source radiance per unit of the sun's irradiance: light that still goes roughly its way, and
/// diffuse light, which comes along the sun's way and of a low sun leaves by base and top
/// meanwhile, or down from the top and leaves by the sides, whichever is more.
double sun_source(const ForwardTable& forward, double asymmetry, const DepthsAround& depths,
                  const glm::dvec3& from_eye, const glm::dvec3& sun_direction) {
  constexpr double width_over_depth = 2.0;  // of heaps
  const double deep = depths.up + depths.down;
  const double sine = std::clamp(sun_direction.z, 0.0, 1.0);
  const double to_base = std::sqrt(1.0 - sine * sine) * decay_along_slab(asymmetry, deep);
  const double to_sides = decay_along_slab(asymmetry, width_over_depth * deep);
  const double cosine = glm::dot(from_eye, sun_direction);
  const double in_peak = in_forward_peak(asymmetry, depths.to_sun);
  const double along_sun = even_radiance(
      two_stream(asymmetry, depths.to_sun, depths.from_sun, to_base), in_peak, cosine);
  const double from_top =
      even_radiance(two_stream(asymmetry, depths.up, depths.down, to_sides), in_peak, from_eye.z);
  return forward.at(depths.to_sun, cosine) + std::max(along_sun, sine * from_top);
}

}  // namespace

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
  const double sun = sun_source(forward, asymmetry, depths, from_eye, light.sun_direction);
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
  const ScatteringBox coarse = coarsened(scattering_box(volume, depth, light));
  const std::vector<glm::vec3> diffuse = diffuse_source(coarse, g * g, light);
  const ForwardTable peak(peak_source, g);
  std::vector<glm::vec3> source(box.count());
  const auto rows = static_cast<std::size_t>(box.voxels.y) * static_cast<std::size_t>(box.voxels.z);
  parallel_for(rows, [&](std::size_t row) {
    const int y = static_cast<int>(row % static_cast<std::size_t>(box.voxels.y));
    const int z = static_cast<int>(row / static_cast<std::size_t>(box.voxels.y));
    for (int x = 0; x < box.voxels.x; ++x) {
      const std::size_t i = box.index({x, y, z});
      if (volume.extinction_per_m[i] <= 0.0F) continue;
      const glm::dvec3 place_m = box.centre_m({x, y, z});
      const glm::dvec3 from_eye = glm::normalize(place_m - light.eye_m);
      const double sun = peak.at(double{depth[i]}, glm::dot(from_eye, light.sun_direction));
      source[i] = glm::max(static_cast<float>(sun) * light.sun_irradiance +
                               BetweenVoxels(coarse.box, place_m).of(diffuse),
                           0.0F);
    }
  });
  return source;
}

}  // namespace wold::cloud
