#pragma once

#include <filesystem>
#include <vector>

#include "cloud/clouds.h"

namespace wold::film {

/// Writes FOLDER/layer_1.png and on, a picture of each layer of the scene, all of it gathered and
/// as it was made: what `clouds.textures` takes and people may look at. 8 bits, sRGB and alpha that
/// is not multiplied in; a whole period, north at the top. Returns the files. Throws
/// FileError.
std::vector<std::filesystem::path> write_cloud_textures(const cloud::Clouds& clouds,
                                                        const std::filesystem::path& folder);

}  // namespace wold::film
