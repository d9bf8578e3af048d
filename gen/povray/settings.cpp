#include "povray/settings.h"

#include <fmt/format.h>

#include <cmath>

namespace wold::povray {
namespace {

/// POV-Ray supersamples a pixel on a square of depth x depth rays where it differs from a
/// neighbour by more than the threshold; grass does nearly everywhere, the sky does not.
std::string antialiasing(int samples) {
  if (samples <= 1) return "Antialias=Off\n";
  return fmt::format(
      "Antialias=On\n"
      "Sampling_Method=1\n"
      "Antialias_Threshold=0.03\n"
      "Antialias_Depth={}\n"
      "Jitter=Off\n",
      static_cast<int>(std::ceil(std::sqrt(samples))));
}

}  // namespace

std::string settings(const landscape::Landscape& scene) {
  return fmt::format(
      "Width={}\n"
      "Height={}\n"
      "{}"
      "Display=Off\n"
      "Output_File_Type=N8 ; PNG, 8 bits per channel\n"
      "Library_Path=.\n"
      "Library_Path=povray\n",
      scene.width_px, scene.height_px, antialiasing(scene.samples));
}

std::string frame_settings(const landscape::Landscape& scene) {
  return settings(scene) + fmt::format(
                               "Input_File_Name=scene.pov\n"
                               "Output_File_Name=frame_{0:04}.png\n"
                               "Declare=FRAME={0}\n",
                               scene.frame);
}

}  // namespace wold::povray
