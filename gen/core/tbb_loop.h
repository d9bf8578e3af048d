#pragma once

#include <cstddef>

namespace wold {

/// TBB's parallel loop, for parallel_for() alone: step(shared, i) for every i in [0, count); it may
/// not throw. In a file of its own, which the thread sanitizer leaves out (CMakeLists.txt): TBB's
/// headers are half of its scheduler, whose other half, in Debian's library, the sanitizer cannot
/// see.
void tbb_loop(std::size_t count, void (*step)(void* shared, std::size_t i), void* shared);

}  // namespace wold
