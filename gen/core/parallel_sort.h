#pragma once

#include <cstdint>
#include <span>

namespace wold {

/// Sorts numbers from the least to the greatest, on all processors. It has a file of its own, which
/// the thread sanitizer leaves out; tbb_loop.h says why.
void parallel_sort(std::span<std::uint64_t> numbers);

}  // namespace wold
