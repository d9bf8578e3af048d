#include "povray/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wold::povray {
namespace {

/// Method 1 casts one ray and, where the pixel differs from a neighbour by more than the threshold,
/// depth x depth more: at most `samples`. Fitting levels have voxels of about a pixel, so
/// little is left to do. Half a metre above the grass, against 9 rays in nearly every pixel and
/// twice the samples in the grass, the root mean square error (of a picture in [0, 1]) is .0101
/// with a threshold of 0.15, .0117 with 0.2 in 16 % less time, .0134 with 0.25 in 28 % less.
std::string antialiasing(int samples) {
  const int depth = static_cast<int>(std::sqrt(samples));
  if (depth < 2) return "Antialias=Off\n";
  return fmt::format(
      "Antialias=On\n"
      "Sampling_Method=1\n"
      "Antialias_Threshold=0.2\n"
      "Antialias_Depth={}\n"
      "Jitter=Off\n",
      depth);
}

}  // namespace

std::string settings(glm::ivec2 size_px, int samples) {
  return fmt::format(
      "Width={}\n"
      "Height={}\n"
      "{}"
      "Display=Off\n"
      "Output_File_Type=N8 ; PNG, 8 bits per channel\n"
      "Dither=On ; no bands in a sky\n"
      "Dither_Method=B4 ; the same for a pixel, whatever is around it\n"
      "Library_Path=.\n"
      "Library_Path=povray\n",
      size_px.x, size_px.y, antialiasing(samples));
}

std::string frame_settings(glm::ivec2 size_px, int samples, int frame) {
  return settings(size_px, samples) + fmt::format(
                                          "Input_File_Name=scene.pov\n"
                                          "Output_File_Name=frame_{0:04}.png\n"
                                          "Declare=FRAME={0}\n",
                                          frame);
}

}  // namespace wold::povray
