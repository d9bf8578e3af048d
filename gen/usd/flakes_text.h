#pragma once

#include <string>

#include "landscape/landscape.h"

namespace wold::usd {

/// Flakes and drops as rectangles that glow, /Landscape/Flakes: a mesh for each picture and step of
/// opacity, of which there are eight. Empty without any.
std::string flakes_text(const landscape::Landscape& landscape);

/// Their materials, for /Landscape/Materials.
std::string flake_materials_text(const landscape::Landscape& landscape);

}  // namespace wold::usd
