#pragma once

#include <nlohmann/json.hpp>

#include "core/layered_image.h"

namespace wold::compare {

/// Whether a picture has layers: names of channels such as "depth.Z".
bool has_layers(const LayeredImage& image);

/// Of each layer its channels with their ranges, and what the file's header says of it: unit and
/// meaning of a pass of Wold's, the names of a Cryptomatte and the fraction of the picture that
/// each covers. Numbers that stand for no number at all, 1e10 and more, are left out of ranges.
nlohmann::ordered_json layers_json(const LayeredImage& image);

/// What the header says of the whole picture.
nlohmann::ordered_json header_json(const LayeredImage& image);

}  // namespace wold::compare
