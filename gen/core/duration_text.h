#pragma once

#include <string>

namespace wold {

/// How long something takes, in words for people: "8.4 s", "1 min 24 s", "2 h 05 min". `seconds` is
/// 0 or more.
std::string duration_text(double seconds);

/// How long something takes, as a clock shows it: "0:08", "1:24", "2:05:09". `seconds` is 0 or
/// more.
std::string clock_text(double seconds);

}  // namespace wold
