#include "grass/texel/coverage.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

using test::degree;

constexpr double patch_m = 0.5;

/// Straight blades, Poisson-like: independent places and headings.
std::vector<Blade> random_blades(std::uint64_t count, double lean_deg, double length_m) {
  std::vector<Blade> blades;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto draw = [&](std::uint64_t purpose) { return random_uniform({11, 12, i, purpose}); };
    const double heading = 2.0 * test::pi * draw(3);
    Blade blade = test::straight_blade();
    blade.root_m = glm::vec2(draw(1), draw(2)) * static_cast<float>(patch_m);
    blade.heading = {std::cos(heading), std::sin(heading)};
    blade.lean = static_cast<float>(lean_deg * degree);
    blade.length_m = static_cast<float>(length_m);
    blade.radius_m = 0.00225F;
    blades.push_back(blade);
  }
  return blades;
}

/// Ground covered by all blades if none hid another, in patches: a cone's silhouette is L r sin.
double depth_of(const std::vector<Blade>& blades, const glm::dvec3& direction) {
  double area = 0.0;
  for (const Blade& blade : blades) {
    const glm::dvec3 axis(glm::dvec2(blade.heading) * std::sin(double{blade.lean}),
                          std::cos(double{blade.lean}));
    area +=
        double{blade.length_m} * double{blade.radius_m} * glm::length(glm::cross(axis, direction));
  }
  return area / direction.z / (patch_m * patch_m);
}

// Boolean model of independent grains: the fraction left free is exp(-mean cover).
TEST(Coverage, OfIndependentBladesFollowsBeersLaw) {
  for (double elevation_deg : {90.0, 45.0, 20.0})
    for (std::uint64_t count : {500U, 2000U}) {
      const auto blades = random_blades(count, 60.0, 0.05);
      const glm::dvec3 direction = direction_at(elevation_deg * degree, 0.4);
      const double seen =
          blade_transmittance(blades, std::vector<BladePose>(blades.size()), patch_m, {direction});
      const double depth = -std::log(seen);
      EXPECT_NEAR(depth / depth_of(blades, direction), 1.0, 0.04)
          << count << " blades from " << elevation_deg << " degrees";
    }
}

TEST(Coverage, OfOneBladeIsItsSilhouetteWhereverItStands) {
  auto blades = random_blades(1, 70.0, 0.3);
  blades[0].radius_m = 0.02F;
  for (float x : {0.25F, 0.49F}) {
    blades[0].root_m = {x, 0.01F};
    const double seen = blade_transmittance(blades, {BladePose{}}, patch_m, {{0.0, 0.0, 1.0}});
    EXPECT_NEAR((1.0 - seen) / depth_of(blades, {0.0, 0.0, 1.0}), 1.0, 0.03);
  }
}

}  // namespace
}  // namespace wold::grass
