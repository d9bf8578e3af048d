#pragma once

#include <filesystem>

#include "landscape/landscape.h"

namespace wold::povray {

/// Writes the flakes as one mesh in centimetres from `eye_m`: flakes.inc in `frame_folder`, a macro
/// call per picture and `#declare Wold_flakes = mesh2 { ... }`, with a texture per picture and
/// opacity in use, opacities rounded to 1/255; and their pictures, NAME.png in `pictures_folder`,
/// of which the name says what is in them: what is there already stays. Without flakes there is no
/// flakes.inc afterwards. Throws FileError.
void write_flakes(const landscape::Flakes& flakes, const glm::dvec3& eye_m,
                  const std::filesystem::path& frame_folder,
                  const std::filesystem::path& pictures_folder);

}  // namespace wold::povray
