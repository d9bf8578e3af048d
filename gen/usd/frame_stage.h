#pragma once

#include <string>

#include "landscape/landscape.h"

namespace wold::usd {

/// The text of a frame's layer, which is a stage by itself. `ground`: the ground's file in "data".
/// Values that a film changes, the camera's, are time samples at the frame's number. The variant
/// set `light` has
///   "baked"  surfaces glow with the radiance of Wold's pictures, whatever lights are there
///   "lit"    surfaces scatter what sun and sky send; this needs Landscape::unlit
/// Throws FileError where a number is not finite.
std::string frame_text(const landscape::Landscape& landscape, const std::string& ground);

}  // namespace wold::usd
