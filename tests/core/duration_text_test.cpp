#include "core/duration_text.h"

#include <gtest/gtest.h>

namespace wold {
namespace {

TEST(DurationText, HasTheUnitsThatTell) {
  EXPECT_EQ(duration_text(0.0), "0.0 s");
  EXPECT_EQ(duration_text(8.44), "8.4 s");
  EXPECT_EQ(duration_text(84.0), "1 min 24 s");
  EXPECT_EQ(duration_text(3599.4), "59 min 59 s");
  EXPECT_EQ(duration_text(7500.0), "2 h 05 min");
}

TEST(DurationText, IsAClock) {
  EXPECT_EQ(clock_text(7.6), "0:08");
  EXPECT_EQ(clock_text(84.0), "1:24");
  EXPECT_EQ(clock_text(7509.0), "2:05:09");
}

}  // namespace
}  // namespace wold
