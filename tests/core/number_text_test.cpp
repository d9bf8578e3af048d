#include "core/number_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wold {
namespace {

TEST(NumberText, IsAllOfTheText) {
  EXPECT_EQ(number_in<int>("-12"), -12);
  EXPECT_EQ(number_in<double>("2.5e3"), 2500.0);
  for (const char* text : {"", " 1", "+1", "1 ", "1x", "x", "1,5"})
    EXPECT_EQ(number_in<int>(text), std::nullopt) << text;
}

TEST(NumberText, FitsItsType) {
  EXPECT_EQ(number_in<int>("2147483648"), std::nullopt);
  EXPECT_EQ(number_in<double>("1e400"), std::nullopt);
  EXPECT_TRUE(std::isinf(number_in<double>("inf").value()));
}

TEST(NumberText, LeadsAndSaysHowFar) {
  const auto number = leading_number<double>("0.25 of it");
  ASSERT_TRUE(number.has_value());
  EXPECT_EQ(number->value, 0.25);
  EXPECT_EQ(number->length, 4U);
  EXPECT_FALSE(leading_number<double>("of it").has_value());
}

}  // namespace
}  // namespace wold
