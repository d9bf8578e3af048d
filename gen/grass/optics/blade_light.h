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
  Fibre fibre;
};

/// Thinner than any blade.
inline constexpr double fine_shadow_pixel_m = 5e-4;

/// Radiance of each place, shaded like the texel (shading.h) but without its voxels: sunlight and
/// skylight reach a place when no other blade of the tiled patch hides it, as far as pictures of
/// the patch with pixels of `shadow_pixel_m` show.
std::vector<glm::vec3> place_radiance(const BladePatch& patch, std::span<const BladePlace> places,
                                      const Lighting& lighting, const FibreLook& look,
                                      double shadow_pixel_m = fine_shadow_pixel_m);

}  // namespace wold::grass
