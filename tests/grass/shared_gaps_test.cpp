#include "grass/optics/shared_gaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "grass/optics/blade_picture.h"
#include "grass/texel/blade_patch.h"

namespace wold::grass {
namespace {

constexpr double degree = 3.14159265358979 / 180.0;

glm::dvec3 from(double zenith_deg, double azimuth_deg) {
  return {std::sin(zenith_deg * degree) * std::sin(azimuth_deg * degree),
          std::sin(zenith_deg * degree) * std::cos(azimuth_deg * degree),
          std::cos(zenith_deg * degree)};
}

/// The default meadow.
class DefaultMeadow : public testing::Test {
 protected:
  BladePatch patch(int variant) const { return WitheringPatch(scene_, model_, variant).at(0.3); }
  SharedGaps gaps() const { return {patch(0), model_}; }

  /// SharedGaps::more_sunlit() of the blades themselves, seen from sun and eye.
  double counted(const glm::dvec3& sun, const glm::dvec3& eye) const {
    constexpr int side = 500;
    double sunlit = 0.0, seen = 0.0, both = 0.0;
    for (int variant = 0; variant < scene_.grass.variants; ++variant) {
      const BladePatch blades = patch(variant);
      const BladePicture by_sun(blades, sun, side), by_eye(blades, eye, side);
      for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
          const glm::vec3 at_m(glm::dvec2(i + 0.5, j + 0.5) * (blades.patch_m / side), 0.0);
          const bool lit = !by_sun.hides(at_m, BladePicture::nothing);
          const bool shown = !by_eye.hides(at_m, BladePicture::nothing);
          sunlit += lit ? 1.0 : 0.0;
          seen += shown ? 1.0 : 0.0;
          both += lit && shown ? 1.0 : 0.0;
        }
    }
    return both / seen - sunlit / (side * side * scene_.grass.variants);
  }

 private:
  const scene::Scene scene_;
  const MeadowModel model_{scene_};
};

TEST_F(DefaultMeadow, DownTheSunsRaysAllGroundThatIsSeenIsSunlit) {
  for (const double zenith_deg : {10.0, 30.0, 50.0, 70.0}) {
    const glm::dvec3 sun = from(zenith_deg, 180.0);
    EXPECT_NEAR(gaps().passing(sun) + gaps().more_sunlit(sun, sun), 1.0, 1e-9);
    EXPECT_NEAR(gaps().passing(sun, 0.3) + gaps().more_sunlit(sun, sun, 0.3), 1.0, 1e-9);
  }
}

TEST_F(DefaultMeadow, GroundIsSunlitAsMuchAsBetweenItsBlades) {
  const glm::dvec3 sun = from(30.0, 180.0);
  const SharedGaps shared = gaps();
  for (const auto& [zenith_deg, azimuth_deg] : {std::pair{28.0, 180.0},
                                                {25.0, 180.0},
                                                {15.0, 180.0},
                                                {50.0, 180.0},
                                                {30.0, 170.0},
                                                {40.0, 0.0}}) {
    SCOPED_TRACE(zenith_deg);
    const glm::dvec3 eye = from(zenith_deg, azimuth_deg);
    EXPECT_NEAR(shared.more_sunlit(sun, eye), counted(sun, eye), 0.04);
  }
}

TEST_F(DefaultMeadow, NothingIsSharedWhereNothingGrows) {
  EXPECT_EQ(gaps().more_sunlit(from(30.0, 180.0), from(30.0, 180.0), 0.0), 0.0);
  EXPECT_EQ(gaps().passing(from(70.0, 0.0), 0.0), 1.0);
}

}  // namespace
}  // namespace wold::grass
