#include "core/at_once.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

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
  std::atomic<int> now = 0, most = 0, done = 0;
  run_at_once(12, 3, [&](std::size_t) {
    const int busy = ++now;
    for (int seen = most; busy > seen && !most.compare_exchange_weak(seen, busy);) {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    --now;
    ++done;
  });
  EXPECT_EQ(most, 3);
  EXPECT_EQ(done, 12);
}

}  // namespace
}  // namespace wold
