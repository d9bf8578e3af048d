#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

/// What loops promise; tests/analysis.sh tsan looks whether bodies get in each other's way.
namespace wold::test {
namespace {

TEST(ParallelFor, DoesEachOnceAlsoInLoopsWithinLoops) {
  std::vector<std::vector<int>> done(40, std::vector<int>(1000, 0));
  parallel_for(done.size(), [&](std::size_t row) {
    parallel_for(done[row].size(), [&](std::size_t i) { ++done[row][i]; });
  });
  for (const std::vector<int>& row : done) EXPECT_EQ(row, std::vector<int>(1000, 1));
}

TEST(ParallelFor, BlocksCoverWhatIsNoWholeBlock) {
  for (const std::size_t count : {0U, 1U, 4096U, 4097U, 10000U}) {
    std::vector<int> done(count, 0);
    parallel_for_blocks(count, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(count, 1));
  }
}

TEST(ParallelFor, ABodysExceptionReachesTheCallerAndEndsTheLoop) {
  std::atomic<int> begun = 0;
  const auto loop = [&] {
    parallel_for(100000, [&](std::size_t i) {
      ++begun;
      if (i == 5) throw std::runtime_error("five");
    });
  };
  EXPECT_THROW(loop(), std::runtime_error);
  EXPECT_LT(begun, 100000);
}

TEST(StopScope, EndsLoopsWithinLoopsOnAllThreads) {
  std::atomic<int> done = 0;
  const auto loops = [&] {
    const StopScope scope([&] {
      if (done >= 100) throw std::runtime_error("stop");
    });
    parallel_for(1000, [&](std::size_t) { parallel_for(1000, [&](std::size_t) { ++done; }); });
  };
  EXPECT_THROW(loops(), std::runtime_error);
  EXPECT_LT(done, 10000);
  EXPECT_GE(done, 100);
}

TEST(StopScope, TheInnermostCountsAndGoesWithItsObject) {
  const StopScope outer([] { throw std::runtime_error("outer"); });
  {
    const StopScope inner([] {});
    EXPECT_NO_THROW(stop_if_asked());
    EXPECT_NO_THROW(parallel_for(10, [](std::size_t) {}));
  }
  EXPECT_THROW(stop_if_asked(), std::runtime_error);
  EXPECT_THROW(parallel_for(10, [](std::size_t) {}), std::runtime_error);
}

TEST(ParallelFor, ScratchIsNeverSharedAndThereIsNoMoreThanThreads) {
  struct Scratch {
    bool taken = false;
  };
  std::atomic<int> made = 0;
  std::atomic<int> shared = 0;
  const ThreadLimit limit(3);
  parallel_for_with_scratch(
      2000,
      [&] {
        ++made;
        return Scratch{};
      },
      [&](std::size_t, Scratch& scratch) {
        if (std::exchange(scratch.taken, true)) ++shared;
        scratch.taken = false;
      });
  EXPECT_EQ(shared, 0);
  EXPECT_GE(made, 1);
  EXPECT_LE(made, 3);
}

}  // namespace
}  // namespace wold::test
