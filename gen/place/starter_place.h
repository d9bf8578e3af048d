#pragma once

#include <string>

#include "scene/starter.h"

namespace wold::place {

/// How a kind's starter scene shows an elevation model: the largest square about its middle, 25 km
/// at most, a height each of its cells, and a camera at find_viewpoint()'s place.
///
/// `elevation` is what the scene will call the file, from the current folder. Throws FileError when
/// it cannot be read, InputError when it is no raster that lies somewhere, when it covers less than
/// 10 m, when half of the square or more has no heights, or when `kind` is none of
/// scene::starter_kinds().
scene::StarterPlace starter_place(const std::string& elevation, const std::string& kind);

}  // namespace wold::place
