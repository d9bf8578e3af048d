#include "wind/profile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wold::wind {
namespace {

// FAO-56's reference grass of 0.12 m: d = 0.08 m, z0 = 0.0148 m.
TEST(Profile, IsTheLogarithmicLawOfAllenOverGrass) {
  const Profile profile(0.12);
  EXPECT_NEAR(profile.roughness_m(), 0.0148, 1e-4);
  EXPECT_DOUBLE_EQ(profile.at(10.0), 1.0);
  EXPECT_NEAR(profile.at(2.0), std::log(1.92 / 0.01476) / std::log(9.92 / 0.01476), 1e-9);
  EXPECT_NEAR(profile.friction(), 0.4 / std::log(9.92 / 0.01476), 1e-9);
}

TEST(Profile, EntersTheCanopyWithoutAKink) {
  const Profile profile(0.4);
  constexpr double step = 1e-6;
  const double top = profile.canopy_m();
  EXPECT_NEAR(profile.at(top - 1e-12), profile.at(top), 1e-9);
  const double below = (profile.at(top) - profile.at(top - step)) / step;
  const double above = (profile.at(top + step) - profile.at(top)) / step;
  EXPECT_NEAR(below / above, 1.0, 1e-4);
  EXPECT_NEAR(profile.at_top() / above, profile.shear_length_m(), 1e-4 * top);
}

// Cionco 1972: attenuations of 2 to 3 in grain and grass; some wind is left at the ground.
TEST(Profile, FallsIntoTheCanopyAsFarAsIsMeasured) {
  const Profile profile(0.4);
  const double attenuation = std::log(profile.at_top() / profile.at(0.0));
  EXPECT_GT(attenuation, 2.0);
  EXPECT_LT(attenuation, 3.3);
}

}  // namespace
}  // namespace wold::wind
