#pragma once

#include <string>

namespace wold {

/// The project's version, such as "0.1.0": that of the top CMakeLists.txt.
extern const char* const version;

/// The compiler and the kind of machine that the program was built with and for: "GCC 12.2.0, Linux
/// x86_64".
extern const char* const build;

/// The commit that the program was built from, as git describes it: "0123456789ab", with "-dirty"
/// after it when files had been changed. "unknown" when it was built outside git. It stands in a
/// file beside the program, so that a commit that changes no code leaves the program, and output
/// folders that it has made, as they are.
std::string revision();

}  // namespace wold
