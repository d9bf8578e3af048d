#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "landscape/landscape.h"
#include "usd/material.h"

namespace wold::usd {

/// Writes the ground as a mesh, /Ground, below `folder` and returns the file's name, which says
/// what is in it. World space; smooth normals; `st` runs from 0 to 1 over the terrain, x east, y
/// north. The faces of the finest of Landscape::ground_details at a place are a subset, `detail_1`
/// and so on, whose borders are faces' borders. Throws FileError.
std::string write_ground(const landscape::Landscape& landscape,
                         const std::filesystem::path& folder);

/// Where `st` of the ground is in a picture with the north at the top, whose values lie on the
/// corners of a square.
PicturePlace place_in(const Heightfield& terrain, const Square& square, int samples);

}  // namespace wold::usd
