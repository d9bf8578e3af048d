#pragma once

#include "core/image.h"
#include "landscape/landscape.h"

namespace wold::preview {

/// The sky all around from the horizon up, from north over east, south and west to north, in
/// encoded sRGB: a quarter as high as it is wide.
Image sky_picture(const landscape::Landscape& landscape, int width_px);

/// Some of the flakes that fall, white on grey, side by side in rows; nothing when none fall.
Image flakes_picture(const landscape::Flakes& flakes, const glm::ivec2& size_px);

}  // namespace wold::preview
