#include "console/console_progress.h"

#include <gmock/gmock.h>

namespace wold::console {
namespace {

using namespace std::chrono_literals;

/// What stands on stderr of work that takes `per_unit` a unit.
std::string shown(ProgressStyle style, std::chrono::seconds per_unit, std::size_t units,
                  std::size_t done) {
  ConsoleProgress::Clock::time_point now{};
  ConsoleProgress progress(style, [&now] { return now; });
  testing::internal::CaptureStderr();
  progress.begin("pictures", units);
  for (std::size_t unit = 0; unit < done; ++unit) {
    now += per_unit;
    progress.advance(1, "frame");
  }
  if (done == units) progress.end();
  return testing::internal::GetCapturedStderr();
}

TEST(ConsoleProgress, SaysHowLongTheRestWillTake) {
  // A quarter took 25 minutes, so that three quarters take 75.
  EXPECT_THAT(
      shown(ProgressStyle::bar, 300s, 20, 5),
      testing::EndsWith("[######..................] pictures 5/20  25 %, 1:15:00 left  frame"));
  EXPECT_EQ(
      shown(ProgressStyle::lines, 3s, 4, 2),
      "pictures\npictures 1/4  25 %, 0:09 left  frame\npictures 2/4  50 %, 0:06 left  frame\n");
}

TEST(ConsoleProgress, SaysInTheEndHowLongItTook) {
  EXPECT_THAT(shown(ProgressStyle::lines, 70s, 3, 3),
              testing::EndsWith("\npictures: done in 3:30\n"));
  EXPECT_EQ(shown(ProgressStyle::none, 70s, 3, 3), "");
}

}  // namespace
}  // namespace wold::console
