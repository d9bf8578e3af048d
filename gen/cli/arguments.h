#pragma once

#include <string>
#include <vector>

namespace wold::cli {

/// "1,5,9-12" as rising frame numbers without repeats. Throws InputError that names the option.
std::vector<int> parse_frames(const std::string& text);

/// "960x540" as the override of render.size. Throws InputError that names the option.
std::string size_override(const std::string& text);

}  // namespace wold::cli
