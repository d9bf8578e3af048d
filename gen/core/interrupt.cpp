#include "core/interrupt.h"

#include <atomic>
#include <csignal>

namespace wold {
namespace {

/// A signal's handler has nothing but a global to write to.
std::atomic<bool> stop_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void request_stop(int) { stop_requested = true; }

}  // namespace

void catch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = request_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

void ignore_size_limits() { std::signal(SIGXFSZ, SIG_IGN); }

bool interrupted() { return stop_requested; }

}  // namespace wold
