#pragma once

namespace wold {

/// The project's version, such as "0.1.0": that of the top CMakeLists.txt.
extern const char* const version;

}  // namespace wold
