#pragma once

#include <cstdint>
#include <span>

namespace wold {

/// Sorts numbers from the least to the greatest, on all processors. In a file of its own, which the
/// thread sanitizer leaves out for the reasons of tbb_loop.h.
void parallel_sort(std::span<std::uint64_t> numbers);

}  // namespace wold
