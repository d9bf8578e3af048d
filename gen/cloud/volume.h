#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "cloud/light_to_eye.h"
#include "cloud/scattering.h"
#include "cloud/voxel_box.h"
#include "light/daylight.h"

namespace wold::cloud {

/// A layer as a volume.
struct CloudVolume {
  VoxelBox box;
  std::vector<float> extinction_per_m;  ///< of the droplets
  double asymmetry = 0.86;
};

/// What shines on a cloud; irradiances in the unit of light::Daylight.
struct CloudLight {
  glm::dvec3 sun_direction = {0.0, 0.0, 1.0};  ///< unit vector, above the horizon
  glm::vec3 sun_irradiance = {};               ///< on a plane that faces the sun
  glm::vec3 sky_irradiance = {};               ///< on a horizontal plane, from above
  glm::vec3 ground_irradiance = {};            ///< from below
  glm::dvec3 eye_m = {};                       ///< who looks at it
  Surroundings surroundings = {};              ///< sky and ground; none: dark
};

/// The light of a scene's day on clouds at a height above the sea, in metres, for an eye: the
/// ground sends up a fifth of what falls on it.
CloudLight cloud_light(const light::Daylight& day, double height_m, const glm::dvec3& eye_m);

/// Optical depths of the droplets between a place and the outside of its cloud.
struct DepthsAround {
  double to_sun = 0.0, from_sun = 0.0;  ///< towards the sun, and the other way
  double up = 0.0, down = 0.0;          ///< towards the zenith, and the ground
};

/// Radiance that a place in a cloud sends per unit of optical depth along a unit direction from the
/// eye. Free of noise: sunlight that still goes roughly its way comes by `forward`, a table of
/// forward_source(), which makes thin edges shine around the sun; the sky's and the ground's light
/// by two-stream diffusion along their ways. The rest of the sun's comes along its way and is lost
/// by base and top, or down from the top and is lost by the sides of a heap that is twice as wide
/// as deep, whichever is more. Of a heap that stands alone the whole is within 35 % of all orders.
glm::vec3 source_at(const ForwardTable& forward, double asymmetry, const DepthsAround& depths,
                    const glm::dvec3& from_eye, const CloudLight& light);

/// Radiance that each voxel with droplets sends to the eye per unit of optical depth: along a ray,
/// radiance gains extinction * source * ds. All orders of scattering without absorption, free of
/// noise: light that left the forward peak by discrete ordinates (diffuse_light.h) on voxels at
/// least twice as large, what of it and of the surroundings goes on to the eye (light_to_eye.h),
/// and sunlight near its way by peak_source(). The layer's own colour of light is not in it. The
/// light's sky_irradiance and ground_irradiance do not count here: its surroundings do.
std::vector<glm::vec3> source_radiance(const CloudVolume& volume, const CloudLight& light);

}  // namespace wold::cloud
