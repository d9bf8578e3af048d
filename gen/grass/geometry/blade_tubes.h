#pragma once

#include "core/tubes.h"
#include "grass/optics/blade_light.h"
#include "grass/optics/shading.h"
#include "grass/texel/blade_patch.h"

namespace wold::grass {

/// A patch's blades as glowing tubes, shaded like the texel that stands for them (shading.h) but
/// without its voxels: light and skylight reach a place of a blade when no other blade of the tiled
/// patch hides it. The reference for the texel, and what stands nearest to the camera.
///
/// Rings are triangles whose outline is as long as the circle's of the cone: a convex body shows
/// its outline over pi on average, so both cover the same. Snow lies on them in tubes of its own
/// (snow_ridge.h), two to a blade that bears some, roof-shaped. Positions are those of the patch,
/// metres, not wrapped; the patch stands unturned. `shadow_pixel_m` is place_radiance()'s.
Tubes blade_tubes(const BladePatch& patch, const MeadowModel& model, const Lighting& lighting,
                  const FibreLook& look, double shadow_pixel_m = fine_shadow_pixel_m);

/// Sets the reflectance and transmittance of a patch's blade_tubes(): AgeingModel::shade() of the
/// leaf; snow sends back what it does not swallow.
void add_leaf_shades(const BladePatch& patch, const MeadowModel& model, Tubes& tubes);

}  // namespace wold::grass
