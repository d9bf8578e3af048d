#pragma once

#include <filesystem>

#include "landscape/landscape.h"

namespace wold::povray {

/// Writes a mesh of blades: NAME.inc, `#declare Wold_mesh = mesh2 { ... }` in centimetres with
/// places in the picture NAME.exr, one row per blade, one pixel per ring: its radiance. The name
/// says what is in them: what is there already and has this layout stays. Throws FileError.
void write_blades(const landscape::BladeMesh& mesh, const std::filesystem::path& folder);

}  // namespace wold::povray
