#include "core/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <exception>
#include <mutex>

namespace wold {
namespace {

/// The first exception of a loop, by the clock.
///
/// It must not leave the body: TBB would cancel everything under the loop, also the loops that
/// OpenVDB runs inside other bodies, which then work on half-made trees.
class Failure {
 public:
  bool happened() const { return happened_; }
  void keep_current() {
    const std::lock_guard lock(mutex_);
    if (!first_) first_ = std::current_exception();
    happened_ = true;
  }
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::atomic<bool> happened_ = false;
  std::mutex mutex_;
  std::exception_ptr first_;
};

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  Failure failure;
  const auto guarded = [&](std::size_t i) {
    if (failure.happened()) return;
    try {
      body(i);
    } catch (...) {
      failure.keep_current();
    }
  };
  // Isolated: a thread that waits here does not start unrelated outer work meanwhile, which would
  // hold that work's memory as well.
  tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t{0}, count, guarded); });
  failure.rethrow();
}

struct ThreadLimit::Control {
  explicit Control(int threads)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads)
    : control_(threads > 0 ? std::make_unique<Control>(threads) : nullptr) {}

ThreadLimit::~ThreadLimit() = default;

}  // namespace wold
