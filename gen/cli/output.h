#pragma once

#include <string_view>

namespace wold::cli {

/// Writes data for other programs to stdout. Throws FileError when it cannot be written (disk
/// full, closed).
void print_data(std::string_view text);

/// Writes a message for people to stderr.
void print_message(std::string_view text);

}  // namespace wold::cli
