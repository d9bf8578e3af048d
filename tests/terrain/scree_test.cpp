#include "terrain/scree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wold::terrain {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double size_m = 2000.0, foot_m = 1000.0, rock_slope_deg = 40.0;

double tangent(double deg) { return std::tan(deg * degree); }

/// A face of 60 degrees, north of a slope that falls away from it to the south; on both a valley
/// whose sides rise east and west of its middle.
Heightfield below_a_face(double slope_deg, int samples = 401, double face_m = 200.0,
                         double sides = 0.0) {
  Heightfield heights_m(samples, size_m);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const glm::dvec2 at_m = heights_m.place_m(i, j);
      const double north_m = at_m.y - foot_m;
      const double height_m =
          north_m < 0.0 ? north_m * tangent(slope_deg) : std::min(north_m * tangent(60.0), face_m);
      heights_m.at(i, j) = static_cast<float>(height_m + sides * std::abs(at_m.x - 0.5 * size_m));
    }
  return heights_m;
}

/// So far before the foot of the face.
double likely(const Heightfield& heights_m, double before_m) {
  const Scree scree(heights_m, rock_slope_deg, 3);
  return double{scree.likely().sample(0.5 * size_m, foot_m - before_m)};
}

TEST(Scree, CoversTheSlopeBelowAFaceNearTheAngleOfRepose) {
  for (const double before_m : {30.0, 200.0, 700.0})
    EXPECT_GT(likely(below_a_face(33.0), before_m), 0.8) << before_m;
}

// Blocks that come down with a head of 20 m stop where the energy line of 27.5 degrees meets the
// ground.
TEST(Scree, EndsAtTheShadowAngle) {
  for (const double slope_deg : {5.0, 10.0, 20.0}) {
    const double end_m = 20.0 / (tangent(27.5) - tangent(slope_deg));
    EXPECT_GT(likely(below_a_face(slope_deg), 0.6 * end_m), 0.7) << slope_deg;
    EXPECT_LT(likely(below_a_face(slope_deg), 1.5 * end_m), 0.1) << slope_deg;
  }
}

TEST(Scree, ComesFromRockAlone) {
  Heightfield slope(201, size_m);
  for (int j = 0; j < 201; ++j)
    for (int i = 0; i < 201; ++i)
      slope.at(i, j) = static_cast<float>(slope.place_m(i, j).y * tangent(26.0));
  const Scree scree(slope, rock_slope_deg, 3);
  EXPECT_LT(std::ranges::max(scree.likely().values()), 0.01F);
  EXPECT_LT(likely(below_a_face(33.0), -500.0), 0.01);  // on the plateau above the face
}

TEST(Scree, DoesNotDependOnTheSteps) {
  for (const double before_m : {20.0, 40.0, 60.0})
    EXPECT_NEAR(likely(below_a_face(15.0, 201), before_m),
                likely(below_a_face(15.0, 401), before_m), 0.2)
        << before_m;
}

// A low face feeds little; where valleys lead it together there is more.
TEST(Scree, IsMoreInGullies) {
  const Scree scree(below_a_face(29.0, 401, 12.0, 0.25), rock_slope_deg, 3);
  const auto at = [&](double aside_m) {
    return double{scree.likely().sample(0.5 * size_m + aside_m, foot_m - 300.0)};
  };
  for (const double aside_m : {-400.0, 400.0}) {
    EXPECT_GT(at(aside_m), 0.1);
    EXPECT_GT(at(0.0), 1.3 * at(aside_m));
  }
}

double mean_share(const Scree& scree, double step_m, double slope_deg) {
  const Scree::Patches patches(scree, step_m);
  double sum = 0.0;
  int count = 0;
  for (double x_m = 5.0; x_m < size_m; x_m += 7.3)
    for (double y_m = 300.0; y_m < 950.0; y_m += 7.9, ++count)
      sum += patches.share({x_m, y_m}, slope_deg, 0.0);
  return sum / count;
}

// Near and far there is as much of it.
TEST(Scree, IsAsMuchHoweverFineItIsSeen) {
  const Scree scree(below_a_face(33.0, 401, 12.0), rock_slope_deg, 3);
  const double from_afar = mean_share(scree, 300.0, 30.0);
  EXPECT_GT(from_afar, 0.15);
  EXPECT_LT(from_afar, 0.85);
  for (const double step_m : {0.03, 1.0, 12.0})
    EXPECT_NEAR(mean_share(scree, step_m, 30.0), from_afar, 0.12) << step_m;
}

TEST(Scree, LiesNowhereSteeperThanItsAngleOfRepose) {
  const Scree scree(below_a_face(33.0), rock_slope_deg, 3);
  EXPECT_GT(mean_share(scree, 1.0, 33.0), 0.5);
  EXPECT_EQ(mean_share(scree, 1.0, 38.0), 0.0);
}

}  // namespace
}  // namespace wold::terrain
