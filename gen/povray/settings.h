#pragma once

#include <glm/glm.hpp>
#include <string>

namespace wold::povray {

/// POV-Ray options (INI form) for pictures of this size and so many samples per pixel, for every
/// frame.
std::string settings(glm::ivec2 size_px, int samples);

/// The same with the frame, the scene file and the picture's name. Works in the folder of
/// scene.pov and in the folder above it when that folder is named "povray".
std::string frame_settings(glm::ivec2 size_px, int samples, int frame);

}  // namespace wold::povray
