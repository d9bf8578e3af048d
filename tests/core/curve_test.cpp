#include "core/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"

namespace wold {
namespace {

TEST(Curve, PassesThroughItsPointsAndHoldsItsEnds) {
  const std::vector<glm::dvec2> points = {{0.1, 1.0}, {0.35, 0.9}, {0.4, 0.2}, {0.9, 0.05}};
  const Curve curve(points);
  for (const glm::dvec2& point : points) EXPECT_EQ(curve(point.x), point.y);
  EXPECT_EQ(curve(0.0), 1.0);
  EXPECT_EQ(curve(1.0), 0.05);
}

TEST(Curve, IsMonotoneBetweenMonotonePoints) {
  // The data RPN 14 of Fritsch and Carlson 1980, where a common cubic spline overshoots.
  const Curve curve({{7.99, 0.0},
                     {8.09, 2.76429e-5},
                     {8.19, 4.37498e-2},
                     {8.7, 0.169183},
                     {9.2, 0.469428},
                     {10.0, 0.943740},
                     {12.0, 0.998636},
                     {15.0, 0.999919},
                     {20.0, 0.999994}});
  double before = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    const double value = curve(7.99 + 12.01 * i / 4000.0);
    EXPECT_GE(value, before);
    EXPECT_LE(value, 0.999994);
    before = value;
  }
}

TEST(Curve, DoesNotOvershootTurningPoints) {
  const Curve curve({{0.0, 0.0}, {0.3, 1.0}, {0.5, 1.0}, {0.6, -0.5}, {1.0, 0.2}});
  for (int i = 0; i <= 1000; ++i) {
    const double x = i / 1000.0;
    EXPECT_LE(curve(x), 1.0);
    EXPECT_GE(curve(x), x < 0.5 ? 0.0 : -0.5);
  }
  EXPECT_EQ(curve(0.4), 1.0);
}

TEST(Curve, ReproducesAStraightLine) {
  const Curve line({{-1.0, 3.0}, {0.5, 0.0}, {2.0, -3.0}});
  for (double x = -1.0; x <= 2.0; x += 0.07) EXPECT_NEAR(line(x), 1.0 - 2.0 * x, 1e-14);
  const Curve identity({{0.0, 0.0}, {1.0, 1.0}});
  for (double x = 0.0; x <= 1.0; x += 0.007) EXPECT_EQ(identity(x), x);
}

TEST(Curve, HasNoKinks) {
  const Curve curve({{0.0, 1.0}, {0.2, 0.9}, {0.5, 0.2}, {1.0, 0.1}});
  constexpr double step = 1e-6;
  for (const double x : {0.2, 0.5}) {
    const double left = (curve(x) - curve(x - step)) / step;
    const double right = (curve(x + step) - curve(x)) / step;
    EXPECT_NEAR(left, right, 1e-3);
    EXPECT_LT(left, -0.1);
  }
}

TEST(Curve, RefusesPointsThatAreNoFunction) {
  EXPECT_THROW(Curve({{0.0, 1.0}}), InputError);
  EXPECT_THROW(Curve({{0.0, 1.0}, {0.0, 0.5}}), InputError);
  EXPECT_THROW(Curve({{0.5, 1.0}, {0.1, 0.5}}), InputError);
  EXPECT_THROW(Curve({{0.0, 1.0}, {1.0, NAN}}), InputError);
}

}  // namespace
}  // namespace wold
