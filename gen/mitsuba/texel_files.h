#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "landscape/landscape.h"

namespace wold::mitsuba {

/// What a volume's files are called: the same for all turns of a texel's level, and different for
/// different content.
std::string texel_name(const landscape::Volume& volume);

/// Writes a volume without its light below `folder`, each voxel of the volume one of the grids':
///   NAME_extinction.vol  1/m, as the volume has it
///   NAME_albedo.vol      of single scattering, means of the unlit texel's by extinction; where
///                        nothing stands the mean of all, since renderers interpolate
/// The name says what is in them: what is there already stays. Throws FileError.
void write_texel(const landscape::Volume& volume, const std::filesystem::path& folder);

/// The files of a volume of that name, in that order.
std::vector<std::filesystem::path> texel_files(const std::string& name,
                                               const std::filesystem::path& folder);

}  // namespace wold::mitsuba
