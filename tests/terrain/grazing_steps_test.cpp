#include "terrain/grazing_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "terrain/surface.h"

namespace wold::terrain {
namespace {

/// A slope that rises to the east.
struct Slope {
  double rise;

  explicit Slope(double deg) : rise(std::tan(deg * std::numbers::pi / 180.0)) {}
  Trodden at(const GrazingSteps& steps, const glm::dvec2& at_m, double step_m) const {
    return steps.at({at_m, rise * at_m.x}, {rise, 0.0}, step_m);
  }
  /// Over 60 m by 60 m.
  template <class Value>
  double mean(const GrazingSteps& steps, double step_m, const Value& value) const {
    constexpr int side = 600;
    double sum = 0.0;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) sum += value(at(steps, {0.1 * i, 0.1 * j}, step_m));
    return sum / (side * side);
  }
};

double bare(const Trodden& place) { return place.bare; }

TEST(GrazingSteps, AreOnSteepMeadowsAlone) {
  const GrazingSteps steps(1.0, 90.0, 3);
  EXPECT_EQ(Slope(14.0).mean(steps, 0.1, bare), 0.0);
  EXPECT_EQ(Slope(43.0).mean(steps, 0.1, bare), 0.0);
  EXPECT_GT(Slope(27.0).mean(steps, 0.1, bare), 0.25);
  EXPECT_EQ(Slope(27.0).mean(GrazingSteps(1.0, 25.0, 3), 0.1, bare), 0.0);  // rock
}

// A tread for every 0.7 m of height.
TEST(GrazingSteps, FollowEachOtherUpTheSlope) {
  const GrazingSteps steps(1.0, 90.0, 3);
  const Slope slope(27.0);
  int treads = 0;
  constexpr int lines = 20;
  for (int line = 0; line < lines; ++line) {
    bool on_tread = slope.at(steps, {0.0, 3.0 * line}, 0.02).bare > 0.3;
    for (double east_m = 0.0; east_m < 100.0; east_m += 0.02) {
      const double bare_here = slope.at(steps, {east_m, 3.0 * line}, 0.02).bare;
      const bool now = on_tread ? bare_here > 0.15 : bare_here > 0.3;
      if (now && !on_tread) ++treads;
      on_tread = now;
    }
  }
  const double wanted = 100.0 * slope.rise / 0.7;
  EXPECT_NEAR(1.0 * treads / lines, wanted, 0.05 * wanted);
}

TEST(GrazingSteps, LeaveTheSlopeAsItIsOnTheWhole) {
  const GrazingSteps steps(1.0, 90.0, 3);
  const Slope slope(27.0);
  EXPECT_NEAR(slope.mean(steps, 0.05, [](const Trodden& place) { return place.gradient.x; }), 0.0,
              0.02 * slope.rise);
  for (double east_m = 10.0; east_m < 12.0; east_m += 0.02) {
    const Trodden place = slope.at(steps, {east_m, 5.0}, 0.02);
    if (place.bare > 0.6) {
      EXPECT_LT(place.gradient.x, -0.3 * slope.rise) << east_m;
    }
    if (place.bare == 0.0) {
      EXPECT_GT(place.gradient.x, 0.2 * slope.rise) << east_m;
    }
  }
}

TEST(GrazingSteps, WearAsMuchOnMapsOfAnyStep) {
  const GrazingSteps steps(0.7, 90.0, 3);
  const Slope slope(27.0);
  const double fine = slope.mean(steps, 0.05, bare);
  for (const double step_m : {0.3, 1.0, 10.0})
    EXPECT_NEAR(slope.mean(steps, step_m, bare), fine, 0.03 * fine) << step_m;
  const Trodden coarse = slope.at(steps, {30.0, 30.0}, 10.0);
  EXPECT_EQ(coarse.gradient, glm::dvec2(0.0));
}

TEST(GrazingSteps, AreOnAShareOfSuchSlopes) {
  const Slope slope(27.0);
  for (const double share : {0.2, 0.5, 0.8}) {
    const GrazingSteps steps(share, 90.0, 9);
    constexpr int side = 100;
    int trodden = 0;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        if (slope.at(steps, {23.0 * i, 23.0 * j}, 50.0).bare > 0.15) ++trodden;
    EXPECT_NEAR(1.0 * trodden / (side * side), share, 0.06) << share;
  }
  EXPECT_EQ(slope.mean(GrazingSteps(0.0, 90.0, 9), 1.0, bare), 0.0);
}

/// A slope of 30 degrees, 32 m wide, on which grass grows in the south alone.
struct Pasture {
  Heightfield heights_m{65, 32.0};
  GrazingSteps steps{1.0, 40.0, 3};
  LandCover cover{south(), {{1, 1.0, 0.0, {}}, {2, 0.0, 0.0, {}}}, 4};

  Pasture() {
    for (int j = 0; j < 65; ++j)
      for (int i = 0; i < 65; ++i) heights_m.at(i, j) = 0.57735F * 0.5F * static_cast<float>(i);
  }
  static GroundMap<int> south() {
    GroundMap<int> number(33, 32.0, 0);
    for (int j = 16; j < 33; ++j)
      for (int i = 0; i < 33; ++i) number.at(i, j) = 1;
    return number;
  }
  Surface surface(const Heightfield& ground_m, const SnowSurface& snow = {}) const {
    return {ground_m, nullptr, {{.size_m = 32.0}, 321}, {.cover = &cover, .grazing_steps = &steps},
            {},       snow};
  }
  /// What is seen of the sun, which stands in the west, over what a slope without steps shows.
  static GroundLight lit(const Surface& surface) {
    const ColourMap full(321, 32.0, glm::vec3(1.0F));
    return surface.lit({full, full, FactorMap(321, 32.0, 1.0F)}, {-0.8, 0.0, 0.6});
  }
};

// Their risers are no rock, and lose no grass: what they make steeper counts in light alone.
TEST(GrazingSteps, MakeASurfaceBareOnItsTreadsAndUnevenInLight) {
  const Pasture pasture;
  const Surface surface = pasture.surface(pasture.heights_m);
  const GroundLight light = Pasture::lit(surface);
  int treads = 0, risers = 0;
  for (int i = 10; i < 310; ++i) {
    EXPECT_NEAR(surface.slope_deg(i, 60), 30.0, 1e-3);
    if (surface.worn(i, 60) > 0.7) {
      EXPECT_LT(light.sun.at(i, 60).g, 0.9F);  // level ground faces this sun less
      ++treads;
    }
    if (surface.worn(i, 60) == 0.0) {
      EXPECT_GT(light.sun.at(i, 60).g, 1.0F);
      ++risers;
    }
    EXPECT_EQ(surface.worn(i, 280), 0.0);  // no meadow
  }
  EXPECT_GT(treads, 50);
  EXPECT_GT(risers, 50);
}

TEST(GrazingSteps, AreEvenedOutBySnow) {
  const Pasture pasture;
  const GroundLight light =
      Pasture::lit(pasture.surface(pasture.heights_m, {[](const glm::dvec2&) { return 0.5; }, {}}));
  for (int i = 10; i < 310; ++i) EXPECT_NEAR(light.sun.at(i, 60).g, 1.0F, 1e-4F);
}

// Grazing light counts less on uneven ground, but there is none.
TEST(GrazingSteps, ThatAreNowhereLeaveLightAsItIs) {
  const Pasture pasture;
  const Heightfield level(65, 32.0);
  const ColourMap full(321, 32.0, glm::vec3(1.0F));
  const GroundLight light =
      pasture.surface(level).lit({full, full, FactorMap(321, 32.0, 1.0F)}, {0.998, 0.0, 0.06});
  EXPECT_EQ(light.sun.at(100, 100).g, 1.0F);
}

}  // namespace
}  // namespace wold::terrain
