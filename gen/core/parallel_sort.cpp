#include "core/parallel_sort.h"

#include <tbb/parallel_sort.h>

namespace wold {

void parallel_sort(std::span<std::uint64_t> numbers) {
  tbb::parallel_sort(numbers.begin(), numbers.end());
}

}  // namespace wold
