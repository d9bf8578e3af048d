#include "place/view.h"

#include <gtest/gtest.h>

namespace wold::place {
namespace {

// Twice as wide as high, 90 degrees across: the picture's edges are 1 and 0.5 to the side of what
// is 1 ahead.
TEST(View, SeesWhatIsInsideThePicture) {
  const View view({{0, 0, 0}, {0, 10, 0}, 90.0}, 200, 100);
  const auto sees = [&](double right, double up) {
    return view.may_see({10.0 * right, 10.0, 10.0 * up}, 1e-6);
  };
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(sees(0.99 * sign, 0.0));
    EXPECT_FALSE(sees(1.01 * sign, 0.0));
    EXPECT_TRUE(sees(0.0, 0.49 * sign));
    EXPECT_FALSE(sees(0.0, 0.51 * sign));
  }
  EXPECT_FALSE(view.may_see({0, -1, 0}, 0.5));
  EXPECT_TRUE(view.may_see({0, -1, 0}, 1.5));
}

TEST(View, MeasuresLengthsInPixels) {
  const View view({{0, 0, 0}, {0, 10, 0}, 90.0}, 200, 100);
  EXPECT_NEAR(view.pixels(1.0, {0, 10, 0}), 10.0, 1e-9);
  EXPECT_NEAR(view.pixels(1.0, {0, 6, 8}), 10.0, 1e-9);
}

}  // namespace
}  // namespace wold::place
