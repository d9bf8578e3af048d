#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "cloud/clouds.h"
#include "light/daylight.h"

namespace wold::cloud {

/// A box of voxels. Numbers of voxels are stored with x fastest, then y, then z, from the
/// south-west of the base up.
struct VoxelBox {
  glm::dvec3 corner_m = {};  ///< south-west corner of the base, world space
  glm::dvec3 voxel_m = {};   ///< sides of a voxel
  glm::ivec3 voxels = {};
  bool repeats = false;  ///< to the east and north: light comes in from the other side

  std::size_t count() const {
    return static_cast<std::size_t>(voxels.x) * static_cast<std::size_t>(voxels.y) *
           static_cast<std::size_t>(voxels.z);
  }
};

/// A layer as a volume.
struct CloudVolume {
  VoxelBox box;
  std::vector<float> extinction_per_m;  ///< as it is seen
  double droplets_per_seen = 1.0;       ///< optical depth of the droplets over that which is seen
  double asymmetry = 0.86;
};

/// A layer that has heads, over a part of the world: its base flat at base_m, its top thickness_m
/// times (depth over the densest, smoothed over a sixth of the thickness)^0.7 higher. Extinction
/// rises over the lowest seventh and falls as sqrt(1 - t) to the top, bitten into between round
/// heads above the base (billow_box.h), and is scaled so that every column has the optical depth,
/// and so the opacity, of the layer there. The box reaches from the base to the layer's thickness.
/// A volume over just the layer's period repeats. `voxels` >= 1 each, side_m > 0. Throws
/// std::bad_optional_access where the layer has no heads.
CloudVolume lifted(const LayerState& state, double pixel_m, const glm::dvec2& south_west_m,
                   const glm::dvec2& side_m, const glm::ivec3& voxels);

/// What shines on a cloud; irradiances in the unit of light::Daylight.
struct CloudLight {
  glm::dvec3 sun_direction = {0.0, 0.0, 1.0};  ///< unit vector, above the horizon
  glm::vec3 sun_irradiance = {};               ///< on a plane that faces the sun
  glm::vec3 sky_irradiance = {};               ///< on a horizontal plane, from above
  glm::vec3 ground_irradiance = {};            ///< from below
  glm::dvec3 eye_m = {};                       ///< who looks at it
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
/// forward_source(), which makes thin edges shine around the sun; the rest of it, the sky's and the
/// ground's light by two-stream diffusion along their ways.
glm::vec3 source_at(const ForwardTable& forward, double asymmetry, const DepthsAround& depths,
                    const glm::dvec3& from_eye, const CloudLight& light);

/// Radiance that each voxel sends to the eye per unit of optical depth: along a ray, radiance gains
/// extinction * source * ds. It is source_at() of the voxel's middle. Optical depths on the way to
/// the sun are swept from plane to plane. The layer's own colour of light is not in it.
std::vector<glm::vec3> source_radiance(const CloudVolume& volume, const CloudLight& light);

}  // namespace wold::cloud
