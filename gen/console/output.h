#pragma once

#include <string>
#include <string_view>

namespace wold::console {

/// Writes data for other programs to stdout; to a terminal it is printable(). Throws FileError when
/// it cannot be written (disk full, closed).
void print_data(std::string_view text);

/// Writes a message for people to stderr, as far as it is printable().
void print_message(std::string_view text);

/// Writes to stderr what may be lost: a bar or a line of progress, as it is. Where stderr takes
/// nothing any more, as on a full disk, the work goes on.
void print_progress(const std::string& text);

}  // namespace wold::console
