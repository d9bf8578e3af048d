#pragma once

#include <glm/glm.hpp>

#include "core/image.h"
#include "core/tubes.h"
#include "landscape/landscape.h"

namespace wold::preview {

/// What the camera sees of a landscape, in encoded sRGB: ground and sky, the grass that stands as
/// meshes, fog and flakes. Volumes of grass and clouds are not drawn: a landscape for a preview has
/// none.
Image camera_picture(const landscape::Landscape& landscape, int width_px);

/// A patch of grass by itself, from the side and a little above, under `light`, which multiplies
/// its radiance; encoded sRGB.
Image patch_picture(const Tubes& tubes, double patch_m, double height_m, const glm::vec3& light,
                    const glm::ivec2& size_px);

/// Radiance times `gain` as encoded sRGB, each pixel the mean of factor x factor of `radiance`.
Image developed(const Image& radiance, double gain, int factor = 1);

}  // namespace wold::preview
