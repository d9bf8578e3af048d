#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grass/optics/shading.h"
#include "grass/texel/blade_patch.h"

namespace wold::grass {

/// A place on a blade of a patch: what its light depends on.
struct BladePlace {
  std::uint32_t blade = 0;  ///< index into BladePatch::blades
  glm::vec3 position_m;     ///< of the axis, on the patch, not wrapped
  float radius_m = 0.0F;    ///< of the blade here
  float area_m2 = 0.0F;     ///< that it stands for, projected, the mean over all directions
  Fibre fibre;
  float along = 0.0F;  ///< of the way from the blade's root to its tip, 0 to 1
};

/// Thinner than any blade.
inline constexpr double fine_shadow_pixel_m = 5e-4;

/// Light on the places of a patch and on the ground below.
struct PlaceLight {
  std::vector<float> sunlit;          ///< fraction of the sun that reaches a place
  std::vector<DiffuseLight> diffuse;  ///< all other light on it
  glm::vec3 on_ground;                ///< mean irradiance
};

/// Sunlight and skylight reach a place when no other blade of the tiled patch hides it, as far as
/// pictures of the patch with pixels of `shadow_pixel_m` show. What blades scatter again is that of
/// a coarse texel of the places (scattered_light.h).
PlaceLight place_light(const BladePatch& patch, std::span<const BladePlace> places,
                       const Lighting& lighting, double shadow_pixel_m = fine_shadow_pixel_m);

/// Radiance of each place in its place_light(), shaded like the texel (shading.h) but without its
/// voxels.
std::vector<glm::vec3> place_radiance(const BladePatch& patch, std::span<const BladePlace> places,
                                      const Lighting& lighting, const FibreLook& look,
                                      double shadow_pixel_m = fine_shadow_pixel_m);

}  // namespace wold::grass
