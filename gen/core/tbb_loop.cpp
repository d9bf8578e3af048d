#include "core/tbb_loop.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace wold {

void tbb_loop(std::size_t count, void (*step)(void* shared, std::size_t i), void* shared) {
  // Isolated: a thread that waits here does not start unrelated outer work meanwhile, which would
  // hold that work's memory as well.
  tbb::this_task_arena::isolate(
      [=] { tbb::parallel_for(std::size_t{0}, count, [=](std::size_t i) { step(shared, i); }); });
}

}  // namespace wold
