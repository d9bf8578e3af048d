#include "reference/sail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grass/ageing/model_table.h"
#include "grass/optics/leaf_optics.h"
#include "support/places.h"

namespace wold::test {
namespace {

using grass::ModelTable;
using std::numbers::pi;

double rad(double degrees) { return degrees * pi / 180.0; }

/// The canopy of sail_vectors.toml.
class KnownCanopy : public testing::Test {
 protected:
  const std::vector<double>& column(const char* name) const { return table_.column(name, 12); }

  grass::LeafSpectrum leaf() const {
    const std::vector<double> none(12, 0.0);
    return grass::LeafOptics({column("wavelength_nm"), column("refractive_index"),
                              column("chlorophyll_cm2_ug"), none, none, column("carotenoid_cm2_ug"),
                              column("brown"), column("water_cm"), column("dry_cm2_g"), none,
                              none})({1.5, 40.0, 8.0, 0.0, 0.01, 0.009});
  }

  CanopyReflectance canopy(std::size_t i) const {
    const LeafLayer layer{
        verhoef_leaf_angles(-0.35, -0.15), {leaf_.reflectance[i], leaf_.transmittance[i]}, 3.0};
    return sail({&layer, 1}, 0.01, column("soil")[i], {rad(30.0), rad(10.0), 0.0});
  }

 private:
  const ModelTable table_{tests_folder() / "grass/sail_vectors.toml"};
  const grass::LeafSpectrum leaf_ = leaf();
};

TEST_F(KnownCanopy, ReflectsAsPublished) {
  constexpr double tolerance = 1e-4;
  for (std::size_t i = 0; i < 12; ++i) {
    SCOPED_TRACE(column("wavelength_nm")[i]);
    const CanopyReflectance got = canopy(i);
    EXPECT_NEAR(got.sky_to_eye, column("rdot")[i], tolerance);
    EXPECT_NEAR(got.sun_to_eye, column("rsot")[i], tolerance);
    EXPECT_NEAR(got.sky_to_all, column("rddt")[i], tolerance);
    EXPECT_NEAR(got.sun_to_all, column("rsdt")[i], tolerance);
    // Sky light's share by the sun's height (Francois et al. 2002).
    const double height = std::sin(rad(60.0));
    const double share = 0.847 - 1.61 * height + 1.04 * height * height;
    const double sun = (1.0 - share) * column("sun")[i], sky = share * column("sky")[i];
    EXPECT_NEAR((got.sun_to_eye * sun + got.sky_to_eye * sky) / (sun + sky), column("resv")[i],
                tolerance);
  }
}

/// A spherical canopy of leaf area index 2 whose leaves absorb half of the light.
LeafLayer half_absorbing() { return {verhoef_leaf_angles(-0.35, -0.15), {0.3, 0.2}, 2.0}; }

TEST(Sail, LeavesSeenLitAreThoseOfTheirDefinition) {
  constexpr int around = 20000;
  for (const double leaf : {5.0, 33.0, 57.0, 80.0, 89.0})
    for (const double sun : {10.0, 40.0, 85.0})
      for (const double view : {0.0, 20.0, 80.0})
        for (const double azimuth : {0.0, 40.0, 90.0, 180.0}) {
          SeenLit wanted;
          for (int i = 0; i < around; ++i) {
            const double turn = 2.0 * pi * (i + 0.5) / around;
            const auto towards = [&](double zenith, double at) {
              return std::cos(rad(leaf)) * std::cos(zenith) +
                     std::sin(rad(leaf)) * std::sin(zenith) * std::cos(turn - at);
            };
            const double both = towards(rad(sun), 0.0) * towards(rad(view), rad(azimuth));
            (both > 0.0 ? wanted.one_side : wanted.two_sides) += std::abs(both) / around;
          }
          const SeenLit got = seen_lit(rad(leaf), {rad(sun), rad(view), rad(azimuth)});
          EXPECT_NEAR(got.one_side, wanted.one_side, 1e-7);
          EXPECT_NEAR(got.two_sides, wanted.two_sides, 1e-7);
        }
}

TEST(Sail, NothingIsLostBetweenWhiteLeavesAndWhiteSoil) {
  LeafLayer white = half_absorbing();
  white.leaf = {0.55, 0.45 - 1e-7};
  const CanopyReflectance got = sail({&white, 1}, 0.0, 1.0, {rad(40.0), rad(20.0), rad(70.0)});
  EXPECT_NEAR(got.sun_to_all, 1.0, 1e-5);
  EXPECT_NEAR(got.sky_to_all, 1.0, 1e-5);
  EXPECT_NEAR(got.sky_to_eye, 1.0, 1e-5);
}

TEST(Sail, SunAndEyeMayChangePlaces) {
  const LeafLayer layer = half_absorbing();
  const CanopyReflectance there = sail({&layer, 1}, 0.05, 0.2, {rad(50.0), rad(20.0), rad(30.0)});
  const CanopyReflectance back = sail({&layer, 1}, 0.05, 0.2, {rad(20.0), rad(50.0), rad(30.0)});
  EXPECT_NEAR(there.sun_to_eye, back.sun_to_eye, 1e-9);
  EXPECT_NEAR(there.sun_to_all, back.sky_to_eye, 1e-9);
}

TEST(Sail, DownTheSunsRaysAllGroundIsSunlit) {
  LeafLayer black = half_absorbing();
  black.leaf = {1e-9, 1e-9};
  const SunAndView down{rad(50.0), rad(50.0), 0.0};
  const double apart = sail({&black, 1}, 0.0, 1.0, down).sun_to_eye;
  const double shared = sail({&black, 1}, 0.1, 1.0, down).sun_to_eye;
  EXPECT_NEAR(shared, std::sqrt(apart), 1e-6);
  // Leaves of that distribution have k of about 1 / (2 cos 50 degrees).
  EXPECT_NEAR(std::log(shared), -0.5 / std::cos(rad(50.0)) * 2.0, 0.06);
}

TEST(Sail, MingledKindsAreOneLayerOfTheirMean) {
  const LeafAngles angles = verhoef_leaf_angles(-0.35, -0.15);
  const GreenAndBrown kinds{{0.06, 0.1}, {0.4, 0.2}, 0.4, 0.0};
  const LeafLayer mean{angles, {0.6 * 0.06 + 0.4 * 0.4, 0.6 * 0.1 + 0.4 * 0.2}, 3.0};
  const SunAndView directions{rad(30.0), rad(45.0), rad(60.0)};
  const CanopyReflectance two = sail(green_and_brown(kinds, angles, 3.0), 0.1, 0.2, directions);
  const CanopyReflectance one = sail({&mean, 1}, 0.1, 0.2, directions);
  EXPECT_NEAR(two.sun_to_eye, one.sun_to_eye, 1e-6);
  EXPECT_NEAR(two.sky_to_eye, one.sky_to_eye, 1e-9);
  EXPECT_NEAR(two.sun_to_all, one.sun_to_all, 1e-9);
  EXPECT_NEAR(two.sky_to_all, one.sky_to_all, 1e-9);
}

TEST(Sail, BrownLeavesBelowHideBehindGreenOnes) {
  const LeafAngles angles = verhoef_leaf_angles(-0.35, -0.15);
  const auto seen = [&](double dissociation) {
    const GreenAndBrown kinds{{0.06, 0.1}, {0.4, 0.2}, 0.4, dissociation};
    return sail(green_and_brown(kinds, angles, 3.0), 0.1, 0.2, {rad(30.0), rad(45.0), rad(60.0)})
        .sun_to_eye;
  };
  EXPECT_LT(seen(1.0), 0.8 * seen(0.0));
}

}  // namespace
}  // namespace wold::test
