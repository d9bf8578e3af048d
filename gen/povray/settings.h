#pragma once

#include <string>

#include "landscape/landscape.h"

namespace wold::povray {

/// POV-Ray options (INI form) for the landscape's size and samples per pixel, for every frame.
std::string settings(const landscape::Landscape& scene);

/// The same with the frame, the scene file and the picture's name. Works in the folder of
/// scene.pov and in the folder above it when that folder is named "povray".
std::string frame_settings(const landscape::Landscape& scene);

}  // namespace wold::povray
