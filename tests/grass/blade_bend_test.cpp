#include "grass/geometry/blade_bend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grass/geometry/blade_tubes.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

constexpr auto rings = static_cast<std::size_t>(BladePlaces::per_blade);

const MeadowModel& meadow() {
  static const MeadowModel shared(test::small_scene());
  return shared;
}

/// Of a withering meadow, under `snow`.
BladePatch patch(double snow = 0.0) {
  return WitheringPatch(test::small_scene(), meadow(), 0).at(0.2, snow);
}

/// Upright, at a place, 0.4 m long.
BladePlaces upright() {
  BladePlaces all;
  all.carried_by = {0};
  for (std::size_t i = 0; i < rings; ++i) {
    const float along = static_cast<float>(i) / (rings - 1);
    all.places.push_back({0, {0.1F, 0.2F, 0.4F * along}, 0.002F, 0.0F, {}, along});
  }
  all.of_blades = rings;
  return all;
}

/// Tubes of one corner: axes.
Tubes axes_of(const BladePlaces& all) {
  Tubes tubes{BladePlaces::per_blade, 1, {}, {}};
  for (const BladePlace& place : all.places) tubes.vertices_m.push_back(place.position_m);
  tubes.radiance.resize(all.places.size());
  return tubes;
}

/// Along each tube.
std::vector<float> lengths_m(const Tubes& axes) {
  std::vector<float> result;
  for (std::size_t first = 0; first < axes.vertices_m.size(); first += rings) {
    float sum_m = 0.0F;
    for (std::size_t i = first + 1; i < first + rings; ++i)
      sum_m += glm::distance(axes.vertices_m[i], axes.vertices_m[i - 1]);
    result.push_back(sum_m);
  }
  return result;
}

// A cantilever under an even load: w = q (6 s^2 - 4 s^3 + s^4) / 24 EI over its length, by linear
// theory, so that the tip has come three times as far as at half the length, within 6 %.
TEST(BladeBend, IsACantilevers) {
  const BladeBend bend{0, 2};  // 10 degrees to the north
  const Tubes axis = bent(axes_of(upright()), upright(), bend);
  const float tip_m = axis.vertices_m.back().y - 0.2F;
  EXPECT_NEAR(tip_m / 0.4F, std::sin(10.0 * std::numbers::pi / 180.0), 0.01);
  for (std::size_t i = 0; i < rings; ++i) {
    const float s = static_cast<float>(i) / (rings - 1);
    const float wanted = (6.0F - 4.0F * s + s * s) * s * s / 3.0F;
    EXPECT_NEAR((axis.vertices_m[i].y - 0.2F) / tip_m, wanted, 0.01F) << s;
    EXPECT_NEAR(axis.vertices_m[i].x, 0.1F, 1e-6F);
  }
}

TEST(BladeBend, KeepsLengthsAndFeet) {
  const BladePatch blades = patch();
  const BladePlaces all = blade_places(blades, meadow());
  const Tubes straight = axes_of(all);
  const std::vector<float> before_m = lengths_m(straight);
  for (const BladeBend& bend : {BladeBend{1, 0}, BladeBend{-2, 3}, BladeBend{-6, -6}}) {
    const Tubes now = bent(straight, all, bend);
    const std::vector<float> now_m = lengths_m(now);
    ASSERT_EQ(now_m.size(), blades.blades.size());
    for (std::size_t i = 0; i < now_m.size(); ++i) {
      EXPECT_NEAR(now_m[i] / before_m[i], 1.0F, 0.01F);
      EXPECT_EQ(now.vertices_m[i * rings], straight.vertices_m[i * rings]);
      // Where it grows from the ground it goes on growing as it did, within the part of the bend
      // that the first sixteenth has.
      const glm::vec3 was = straight.vertices_m[i * rings + 1] - straight.vertices_m[i * rings];
      const glm::vec3 is = now.vertices_m[i * rings + 1] - now.vertices_m[i * rings];
      const double bend_rad = std::hypot(bend.east, bend.north) * BladeBend::step_rad;
      EXPECT_GT(glm::dot(glm::normalize(was), glm::normalize(is)), std::cos(0.13 * bend_rad));
      for (std::size_t k = i * rings; k < (i + 1) * rings; ++k)
        EXPECT_GE(now.vertices_m[k].z, std::min(-1e-6F, straight.vertices_m[k].z));
    }
  }
}

TEST(BladeBend, PutsTheTipOfAStraightBladeWhereItSays) {
  for (const BladeBend& bend : {BladeBend{1, 0}, BladeBend{2, 3}, BladeBend{3, -8}}) {
    const Tubes axis = bent(axes_of(upright()), upright(), bend);
    const glm::vec3 tip_m = axis.vertices_m.back() - axis.vertices_m.front();
    EXPECT_LT(glm::distance(glm::dvec2(tip_m) / double{tip_m.z}, tip_lean(bend)), 1e-4);
    EXPECT_LT(tip_m.z, 0.4F);
  }
  EXPECT_EQ(tip_lean({}), glm::dvec2(0.0));
}

TEST(BladeBend, NearestIsWithinHalfAStep) {
  for (const int multiple : {1, 2, 4})
    for (int i = 0; i < 60; ++i) {
      const double angle = 0.011 * i, azimuth = 0.37 * i;
      const glm::dvec2 lean = std::tan(angle) * glm::dvec2(std::cos(azimuth), std::sin(azimuth));
      const BladeBend bend = nearest_bend(lean, multiple);
      EXPECT_EQ(bend.east % multiple, 0);
      EXPECT_EQ(bend.north % multiple, 0);
      const glm::dvec2 wanted = angle * glm::dvec2(std::cos(azimuth), std::sin(azimuth));
      const glm::dvec2 apart =
          glm::abs(BladeBend::step_rad * glm::dvec2(bend.east, bend.north) - wanted);
      EXPECT_LE(std::max(apart.x, apart.y), 0.5 * multiple * BladeBend::step_rad + 1e-9);
    }
}

// Snow stays as far from the blade it lies on as it was.
TEST(BladeBend, TakesSnowAlong) {
  const BladePlaces all = blade_places(patch(0.6), meadow());
  ASSERT_GT(all.places.size(), all.of_blades);
  const Tubes straight = axes_of(all), now = bent(straight, all, {4, 3});
  const auto off_m = [&](const Tubes& axes, std::size_t ring) {
    const BladePlace& place = all.places[ring];
    float nearest_m = 1.0F;
    for (std::size_t i = 0; i + 1 < rings; ++i) {
      const std::size_t k = place.blade * rings + i;
      const glm::vec3 a = axes.vertices_m[k], b = axes.vertices_m[k + 1], p = axes.vertices_m[ring];
      const float t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0F, 1.0F);
      nearest_m = std::min(nearest_m, glm::distance(p, glm::mix(a, b, t)));
    }
    return nearest_m;
  };
  for (std::size_t ring = all.of_blades; ring < all.places.size(); ring += 5)
    EXPECT_NEAR(off_m(now, ring), off_m(straight, ring), 1.5e-3F);
}

}  // namespace
}  // namespace wold::grass
