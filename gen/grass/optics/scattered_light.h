#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "grass/optics/diffuse_light.h"
#include "grass/optics/shading.h"
#include "grass/texel/volume_data.h"

namespace wold::grass {

/// How many voxels along its side a patch is cut into for light that is scattered again: it changes
/// little from place to place.
inline constexpr int scattering_side = 30;

/// Matter of a tiled patch that scatters light, voxel by voxel.
struct Scatterer {
  TexelShape shape;
  std::vector<std::uint32_t> voxel;
  std::vector<float> extinction_per_m;
  std::vector<glm::vec3> albedo;
  /// Radiance that it sends to all sides of the sun's light, scattered once.
  std::vector<glm::vec3> sun_source;
};

/// What the ground below a patch gets and sends back.
struct GroundBelow {
  glm::vec3 albedo;
  glm::vec3 sun_irradiance;  ///< mean, through the patch
};

/// Light in a patch.
struct ScatteredLight {
  /// On each voxel, what others and the ground have scattered, any number of times. The sky's own
  /// light is not in it.
  std::vector<DiffuseLight> on_matter;
  glm::vec3 on_ground;  ///< mean irradiance of the ground below, the sun's and the sky's included
};

/// Follows sun and sky through a patch.
///
/// Orders of scattering are summed by sweeps along the directions of the sky and their opposites;
/// what is left after a few is a geometric series. Matter sends what it scatters again to all sides
/// alike, and the ground sends back the mean of what falls on it.
ScatteredLight scattered_light(const Scatterer& matter, const GroundBelow& ground,
                               const Lighting& lighting);

}  // namespace wold::grass
