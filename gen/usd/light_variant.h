#pragma once

#include <string>

#include "landscape/landscape.h"
#include "usd/grass_text.h"

namespace wold::usd {

/// A choice of the variant set `light` of a frame: the sky's picture, all materials, and, where the
/// light is baked, the picture of clouds before the sky.
std::string light_variant(const landscape::Landscape& landscape, const Grass& grass, Light light);

}  // namespace wold::usd
