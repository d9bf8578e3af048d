#include "core/at_once.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <vector>

#include "core/parallel.h"

namespace wold {

void run_at_once(std::size_t count, std::size_t at_once,
                 const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next = 0;
  const InheritedStop::Check check = InheritedStop::of_this_thread();
  const auto work = [&] {
    const InheritedStop inherited(check);
    try {
      for (std::size_t i; (i = next++) < count;) {
        stop_if_asked();
        body(i);
      }
    } catch (...) {
      next = count;
      throw;
    }
  };
  std::vector<std::future<void>> workers;
  for (std::size_t k = 0; k < std::min(count, at_once); ++k)
    workers.push_back(std::async(std::launch::async, work));
  for (const std::future<void>& worker : workers) worker.wait();
  for (std::future<void>& worker : workers) worker.get();
}

}  // namespace wold
