#pragma once

namespace wold {

/// The project's version; the same as in the top CMakeLists.txt, which the tests check.
inline constexpr const char* version = "0.1.0";

}  // namespace wold
