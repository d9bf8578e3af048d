#include "core/at_once.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/parallel.h"

namespace wold {
namespace {

TEST(RunAtOnce, OneByOneIsInOrderAndEndsWithTheFirstFailure) {
  std::vector<std::size_t> seen;
  EXPECT_THROW(run_at_once(9, 1,
                           [&](std::size_t i) {
                             seen.push_back(i);
                             if (i == 2) throw std::runtime_error("stop");
                           }),
               std::runtime_error);
  EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(RunAtOnce, NeverMoreThanAllowedAndAll) {
  std::atomic<int> now = 0, max = 0, done = 0;
  run_at_once(12, 3, [&](std::size_t) {
    const int busy = ++now;
    for (int seen = max; busy > seen && !max.compare_exchange_weak(seen, busy);) {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    --now;
    ++done;
  });
  EXPECT_EQ(max, 3);
  EXPECT_EQ(done, 12);
}

// A signal that comes while tasks run at once has to reach them.
TEST(RunAtOnce, BodiesHearTheCallersStop) {
  std::atomic<bool> stop = false;
  std::atomic<int> begun = 0, ended = 0;
  const StopScope scope([&] {
    if (stop) throw std::runtime_error("stop");
  });
  EXPECT_THROW(run_at_once(20, 2,
                           [&](std::size_t) {
                             ++begun;
                             stop = true;
                             parallel_for(4, [](std::size_t) {});
                             ++ended;
                           }),
               std::runtime_error);
  EXPECT_LE(begun, 2);
  EXPECT_EQ(ended, 0);
}

}  // namespace
}  // namespace wold
