#pragma once

#include <string>
#include <string_view>

namespace wold {

/// Text as it may stand on a terminal, whoever wrote it: "?" in place of every byte that is no
/// UTF-8, of control characters (also those from U+0080 to U+009F), which terminals obey, and of
/// the marks that turn the direction of writing (Unicode's Trojan Source). Line feeds and tabs
/// stay.
std::string printable(std::string_view text);

}  // namespace wold
