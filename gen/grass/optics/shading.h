#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "grass/texel/texel.h"
#include "grass/texel/volume_data.h"
#include "light/daylight.h"

namespace wold::grass {

/// Light that a texel is shaded for, in world directions. Radiance and irradiance in the unit of
/// light::Daylight.
struct Lighting {
  glm::dvec3 sun_direction;  ///< unit, towards the sun
  glm::vec3 sun_irradiance;
  std::vector<glm::vec3> sky_radiance;  ///< mean per ring of sky_rings()
  glm::dvec3 eye_direction;             ///< unit, towards the camera, for the highlight
};

/// A ring of sky directions: elevation in radians, and the solid angle of each of its directions.
struct SkyRing {
  double elevation;
  double solid_angle;
};
/// The rings the sky is sampled by; each has four directions, a quarter-turn apart, so that the
/// sum is the same for every quarter-turn of the texel.
const std::vector<SkyRing>& sky_rings();

/// One of the directions the sky is sampled by, unit, and the irradiance across it.
struct SkyDirection {
  glm::dvec3 direction;
  glm::vec3 irradiance;
};
std::vector<SkyDirection> sky_directions(const Lighting& lighting);

Lighting make_lighting(const light::Daylight& daylight, const glm::dvec3& eye_direction);

/// Kajiya-Kay diffuse response: sine of the angle between fibre and light, scaled to a mean of 1
/// over all directions (the mean sine is pi / 4), so that shading keeps energy.
float kajiya_kay_diffuse(const glm::vec3& tangent, const glm::vec3& light);

/// Kajiya-Kay highlight (1989, eq. 14): (sin(t,l) sin(t,v) - cos(t,l) cos(t,v))^gloss for unit
/// vectors that point away from the fibre; 1 on the mirror cone.
float kajiya_kay_specular(const glm::vec3& tangent, const glm::vec3& light, const glm::vec3& view,
                          float specular_exponent);

/// Sun and eye as a patch sees them that stands turned by quarter-turns (counter-clockwise from
/// above). The sky is the same for all.
struct TurnedLight {
  TurnedLight(const Lighting& lighting, int turn);
  glm::dvec3 sun;  ///< unit, towards it
  glm::vec3 sun_irradiance;
  glm::vec3 eye;  ///< unit, towards it
};

/// A bit of a blade, as Kajiya and Kay shade it.
struct Fibre {
  glm::vec3 tangent;  ///< unit
  glm::vec3 albedo;
  float specular;
};

/// Radiance that a fibre sends in every direction.
///
/// `sunlit`: fraction of the sun that reaches it; `skylight`: the sky's irradiance that does,
/// weighted by the diffuse response.
///
/// The highlight is Kajiya-Kay's for the sun; the sky is so wide that its highlight is the same
/// for every view.
///
/// Fibres intercept the sun by the diffuse response and scatter alike in all directions: albedo /
/// (4 pi) of it. Light scattered again by other fibres is added by the photon recollision
/// probability p: 1 / (1 - p albedo) (Smolander and Stenberg 2005), p = 0.45 for a canopy of leaf
/// area index 2 to 3.
glm::vec3 source_radiance(const Fibre& fibre, const TurnedLight& light, float sunlit,
                          const glm::vec3& skylight, float specular_exponent);

/// Kajiya-Kay's exponent and the width of a blade, within which it does not shadow itself.
struct FibreLook {
  float specular_exponent = 24.0F;
  double width_m = 0.0;
};

/// Scattered skylight per voxel of the texel: integral of radiance * transmittance * diffuse
/// response over the sky, without albedo. Skylight is smooth: its transmittance is taken from
/// `occluder`, a coarser volume of the same patch.
std::vector<glm::vec3> skylight(const Texel& texel, const VolumeData& occluder,
                                const Lighting& lighting, const FibreLook& look);

/// Source radiance per voxel, for a texel that stands turned by `turn` quarter-turns: sunlight
/// through the tiled texel and skylight, scattered by its fibres. `density`: the extinction per
/// voxel of the texel that shadows it.
std::vector<glm::vec3> bake_emission(const Texel& texel, const std::vector<float>& density,
                                     const std::vector<glm::vec3>& skylight,
                                     const Lighting& lighting, const FibreLook& look, int turn);

}  // namespace wold::grass
