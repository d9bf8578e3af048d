#include "core/simd_turns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace wold {
namespace {

TEST(Turns, SinesAreTrueToAMillionth) {
  for (int i = -3000; i <= 3000; ++i) {
    const float turns = static_cast<float>(i) / 1024.0F;  // exact
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(turns);
    ASSERT_NEAR(static_cast<double>(cosine_of_turns(turns)), std::cos(angle), 7e-7) << turns;
    ASSERT_NEAR(static_cast<double>(sine_of_turns(turns)), std::sin(angle), 7e-7) << turns;
  }
}

TEST(Turns, WrapRoundExactly) {
  EXPECT_EQ(off_whole(1e9 + 0.25), 0.25);
  EXPECT_EQ(off_whole(-7.125), -0.125);
  EXPECT_EQ(turn_of(-0.25), 0xc0000000U);
  EXPECT_EQ(turn_of(3.75) + turn_of(0.5), 0x40000000U);
}

}  // namespace
}  // namespace wold
