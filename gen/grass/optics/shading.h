#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "grass/optics/diffuse_light.h"
#include "grass/texel/texel.h"
#include "grass/texel/volume_data.h"
#include "light/daylight.h"

namespace wold::grass {

/// Light that a texel is shaded for, in world directions. Radiance and irradiance in the unit of
/// light::Daylight.
struct Lighting {
  glm::dvec3 sun_direction;  ///< unit, towards the sun
  glm::vec3 sun_irradiance;
  std::vector<glm::vec3> sky_radiance;  ///< mean_sky()'s
  glm::dvec3 eye_direction;             ///< unit, towards the camera
  glm::vec3 ground_albedo{0.0F};        ///< of the bare ground that the grass stands on
};

/// A ring of sky directions, one to each quarter of the sky: elevation in radians, and the solid
/// angle of each of its directions.
struct SkyRing {
  double elevation;
  double solid_angle;
};
/// The rings the sky is sampled by; each has four directions, a quarter-turn apart, so that they
/// are the same for every quarter-turn of the texel.
const std::vector<SkyRing>& sky_rings();
/// How many directions all rings have.
std::size_t sky_size();

/// One of the directions the sky is sampled by, unit, the solid angle that it stands for, and the
/// mean radiance there.
struct SkyDirection {
  glm::dvec3 direction;
  float solid_angle;
  glm::vec3 radiance;

  /// Across the direction.
  glm::vec3 irradiance() const { return solid_angle * radiance; }
};
std::vector<SkyDirection> sky_directions(const Lighting& lighting);

/// Mean radiance of a sky, without the sun, in each quarter of each ring.
std::vector<glm::vec3> mean_sky(const light::Daylight& daylight);

Lighting make_lighting(const light::Daylight& daylight, const glm::dvec3& eye_direction,
                       const glm::vec3& ground_albedo);

/// Kajiya-Kay diffuse response: sine of the angle between fibre and light, scaled to a mean of 1
/// over all directions (the mean sine is pi / 4), so that shading keeps energy.
float kajiya_kay_diffuse(const glm::vec3& tangent, const glm::vec3& light);

/// Kajiya-Kay highlight (1989, eq. 14): (sin(t,l) sin(t,v) - cos(t,l) cos(t,v))^specular_exponent
/// for unit vectors that point away from the fibre; 1 on the mirror cone.
float kajiya_kay_specular(const glm::vec3& tangent, const glm::vec3& light, const glm::vec3& view,
                          float specular_exponent);

/// The lighting as a patch sees it that stands turned by quarter-turns (counter-clockwise from
/// above).
Lighting turned(const Lighting& lighting, int turn);

/// Sun and eye of turned().
struct TurnedLight {
  TurnedLight(const Lighting& lighting, int turn);
  glm::dvec3 sun;  ///< unit, towards it
  glm::vec3 sun_irradiance;
  glm::vec3 eye;  ///< unit, towards it
};

/// A bit of a blade, as Kajiya and Kay shade it.
struct Fibre {
  glm::vec3 tangent;        ///< unit
  glm::vec3 albedo;         ///< reflectance and transmittance together
  glm::vec3 transmittance;  ///< what leaves on the side that the light does not fall on
  float specular;
  float along = 0.5F;  ///< of the way from the blade's root to its tip, 0 to 1
};

/// The fraction of the light that a fibre takes which its highlight sends on, for a coefficient of
/// 1: pi / 8 times the integral of cos^p over the angle from the mirror cone.
float highlight_albedo(float specular_exponent);

/// The fraction of the light that a fibre takes which its highlight sends on: no more than it
/// reflects.
glm::vec3 mirrored_fraction(const Fibre& fibre, float specular_exponent);

/// Radiance that a fibre sends to the eye.
///
/// `sunlit`: fraction of the sun that reaches it; `diffuse`: all other light that does.
///
/// Fibres take light by the diffuse response and scatter it as leaves that are turned about their
/// axis by any angle (leaf_phase()). The highlight is a part of what they reflect: what it sends is
/// taken from the rest.
glm::vec3 source_radiance(const Fibre& fibre, const TurnedLight& light, float sunlit,
                          const DiffuseLight& diffuse, float specular_exponent);

/// Radiance of the sun's light that a fibre scatters, the mean over all directions.
glm::vec3 scattered_sunlight(const Fibre& fibre, const TurnedLight& light, float sunlit);

/// Kajiya-Kay's exponent, the width of a blade, within which it does not shadow itself, and what
/// stands around the patch.
struct FibreLook {
  float specular_exponent = 24.0F;
  double width_m = 0.0;
  double neighbours_m = 0.0;     ///< what is higher than this does not stand beside every patch
  double like_neighbours = 1.0;  ///< share of the patches beside it that have what is higher
};

/// What of each direction of the sky reaches each voxel of a volume, through the others.
std::vector<std::vector<float>> sky_transmittances(const VolumeData& volume, const FibreLook& look);

/// The sky's light on each voxel, by what of it comes through.
std::vector<DiffuseLight> skylight(const std::vector<std::vector<float>>& through,
                                   const Lighting& lighting);

/// Fraction of the sun that reaches each voxel of a volume that stands turned by `turn`
/// quarter-turns.
std::vector<float> sunlit_fractions(const VolumeData& volume, const Lighting& lighting,
                                    const FibreLook& look, int turn);

}  // namespace wold::grass
