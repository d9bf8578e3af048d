#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

namespace wold {

/// Runs body(i) for every i in [0, count) on TBB's threads. The body may write only what belongs
/// to i, so the result is the same for any number of threads; sums over i are formed afterwards,
/// in order. An exception thrown by a body reaches the caller.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

/// The same for bodies so short that a thread has to take thousands of them at a time.
template <class Body>
void parallel_for_blocks(std::size_t count, const Body& body) {
  constexpr std::size_t block = 4096;
  parallel_for((count + block - 1) / block, [&](std::size_t b) {
    const std::size_t end = std::min(count, (b + 1) * block);
    for (std::size_t i = b * block; i < end; ++i) body(i);
  });
}

/// Runs body(i, scratch) for every i in [0, count) as parallel_for() does, for bodies that need
/// memory to work in. make() gives a scratch, of which there are at most as many as threads. Bodies
/// use them in turn and have to leave them as they were. tbb::enumerable_thread_specific would not
/// do: a thread that waits for a loop inside a body may begin another body, with the same scratch.
template <class Make, class Body>
void parallel_for_with_scratch(std::size_t count, const Make& make, const Body& body) {
  using Scratch = std::invoke_result_t<Make>;
  std::mutex mutex;
  std::vector<std::unique_ptr<Scratch>> free;
  const auto taken = [&]() -> std::unique_ptr<Scratch> {
    const std::lock_guard lock(mutex);
    if (free.empty()) return nullptr;
    auto scratch = std::move(free.back());
    free.pop_back();
    return scratch;
  };
  parallel_for(count, [&](std::size_t i) {
    auto scratch = taken();
    if (!scratch) scratch = std::make_unique<Scratch>(make());
    body(i, *scratch);
    const std::lock_guard lock(mutex);
    free.push_back(std::move(scratch));
  });
}

/// Long loops hear in time that they should stop. While a StopScope lives, `check` is asked before
/// every body of parallel_for() that its thread runs, or that loops inside such bodies run on any
/// thread, and by stop_if_asked(). It throws to stop them, usually InterruptedError, and is called
/// by many threads at once. The innermost scope counts.
class StopScope {
 public:
  explicit StopScope(std::function<void()> check);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

 private:
  std::function<void()> check_;
  const std::function<void()>* outer_;
};

/// A thread that works for another one stops when that one should: while this lives in it, the
/// StopScope that counted where `check` was asked for counts here.
class InheritedStop {
 public:
  using Check = const std::function<void()>*;

  /// That of the calling thread, for the threads it starts; it has to outlive them.
  static Check of_this_thread();

  explicit InheritedStop(Check check);
  ~InheritedStop();
  InheritedStop(const InheritedStop&) = delete;
  InheritedStop& operator=(const InheritedStop&) = delete;

 private:
  Check before_;
};

/// For loops that take seconds on one thread: throws what the StopScope around them throws.
void stop_if_asked();

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
