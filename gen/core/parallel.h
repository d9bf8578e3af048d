#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace wold {

/// Runs body(i) for every i in [0, count) on TBB's threads. The body may write only what belongs
/// to i, so the result is the same for any number of threads; sums over i are formed afterwards,
/// in order. An exception thrown by a body reaches the caller.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// Limits the threads of everything that runs while it lives; 0 means all processors.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

}  // namespace wold
