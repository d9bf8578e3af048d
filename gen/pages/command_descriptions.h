#pragma once

#include <string_view>

namespace wold::pages {

/// What a command of command_table() does, for its manual page: sentences.
std::string_view command_description(std::string_view command);

}  // namespace wold::pages
