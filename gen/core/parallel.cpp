#include "core/parallel.h"

#include <tbb/global_control.h>

#include <atomic>
#include <exception>
#include <mutex>
#include <utility>

#include "core/tbb_loop.h"

namespace wold {
namespace {

/// Of the innermost StopScope of what this thread is doing, which may be a body of another thread's
/// loop; else none.
thread_local const std::function<void()>* stop_check = nullptr;

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

/// Says to the thread sanitizer what it cannot see in Debian's TBB, which is not instrumented: that
/// bodies start after their loop has begun and have ended when it ends. It learns nothing of one
/// body before another, so that it finds what they do to each other.
class Order {
#ifdef __SANITIZE_THREAD__
 public:
  void loop_begins() { begun_.store(true, std::memory_order_release); }
  void body_begins() const { (void)begun_.load(std::memory_order_acquire); }
  void body_ends() { bodies_ended_.fetch_add(1, std::memory_order_release); }
  void loop_ends() const { (void)bodies_ended_.load(std::memory_order_acquire); }

 private:
  std::atomic<bool> begun_ = false;
  std::atomic<std::size_t> bodies_ended_ = 0;
#else
 public:
  void loop_begins() {}
  void body_begins() const {}
  void body_ends() {}
  void loop_ends() const {}
#endif
};

/// One loop, as its bodies see it.
class Loop {
 public:
  explicit Loop(const std::function<void(std::size_t)>& body) : body_(body) {}
  void run(std::size_t count) {
    order_.loop_begins();
    tbb_loop(count, step, this);
    order_.loop_ends();
    failure_.rethrow();
  }

 private:
  static void step(void* loop, std::size_t i) { static_cast<Loop*>(loop)->run_body(i); }
  void run_body(std::size_t i) {
    order_.body_begins();
    const InheritedStop inherited(check_);
    try {
      stop_if_asked();
      if (!failure_.happened()) body_(i);
    } catch (...) {
      failure_.keep_current();
    }
    order_.body_ends();
  }

  const std::function<void(std::size_t)>& body_;
  InheritedStop::Check check_ = InheritedStop::of_this_thread();
  Failure failure_;
  Order order_;
};

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body) {
  Loop(body).run(count);
}

StopScope::StopScope(std::function<void()> check)
    : check_(std::move(check)), outer_(std::exchange(stop_check, &check_)) {}

StopScope::~StopScope() { stop_check = outer_; }

InheritedStop::Check InheritedStop::of_this_thread() { return stop_check; }

InheritedStop::InheritedStop(Check check) : before_(std::exchange(stop_check, check)) {}

InheritedStop::~InheritedStop() { stop_check = before_; }

void stop_if_asked() {
  if (stop_check != nullptr) (*stop_check)();
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
