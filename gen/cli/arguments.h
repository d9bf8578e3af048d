#pragma once

#include <string>
#include <vector>

#include "place/wind_at.h"

namespace wold::cli {

/// "1,5,9-12" as rising frame numbers without repeats. Throws InputError that names the option.
std::vector<int> parse_frames(const std::string& text);

/// "960x540" as the override of render.size. Throws InputError that names the option.
std::string size_override(const std::string& text);

/// "21,20,0.3,4.5" as east and north, height above the ground, and time. Throws InputError that
/// names the option.
place::WindPoint parse_wind_point(const std::string& text);

}  // namespace wold::cli
