#include "snow/falling_snow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "core/parallel.h"
#include "core/random.h"
#include "snow/near_field.h"
#include "snow/size_distribution.h"

namespace wold::snow {
namespace {

constexpr double pi = std::numbers::pi;

const FlakePictures& pictures() {
  static const FlakePictures made(1);
  return made;
}

scene::Scene snowy(double rate_mm_h, scene::WindPattern field = scene::WindPattern::gusts) {
  scene::Scene scene;
  scene.weather.temperature_c = -5.0;
  scene.weather.precipitation_mm_h = rate_mm_h;
  scene.wind.field = field;
  return scene;
}

const SnowView level_view = {
    .eye_m = {21.0, 2.0, 1.6}, .target_m = {24.0, 20.0, 1.6}, .width_px = 640, .height_px = 360};

/// So low that it hides nothing.
const Heightfield& no_ground() {
  static const Heightfield ground(2, 42.0, -1e6F);
  return ground;
}

SeenFlakes seen_of(const scene::Scene& scene, double time_s = 50.0,
                   const SnowView& view = level_view, const Heightfield& ground = no_ground()) {
  return FallingSnow(scene, Weather(scene, nullptr), pictures()).at(time_s, view, ground);
}

/// What a flake hides of what lies behind it, m2.
double cross_section_m2(const SeenFlake& flake, const glm::dvec3& eye_m) {
  const glm::dvec3 area = 4.0 * glm::cross(glm::dvec3(flake.right_m), glm::dvec3(flake.up_m));
  const glm::dvec3 to_eye = glm::normalize(eye_m - glm::dvec3(flake.centre_m));
  return static_cast<double>(flake.opacity * pictures().mean_opacity(flake.picture)) *
         std::abs(glm::dot(area, to_eye));
}

TEST(FallingSnow, IsAsManyFlakesAsAskedFor) {
  scene::Scene scene = snowy(1.0);
  EXPECT_NEAR(static_cast<double>(seen_of(scene).flakes.size()), 30000.0, 900.0);
  scene.snowfall.flakes = 5000;
  EXPECT_NEAR(static_cast<double>(seen_of(scene).flakes.size()), 5000.0, 300.0);
}

/// What is drawn between two distances, as a fraction of what there is by the size distribution.
double drawn_fraction(const std::vector<SeenFlake>& flakes, double rate_mm_h, double from_m,
                      double to_m) {
  const Frustum frustum(level_view);
  double sum_m2 = 0.0;
  for (const SeenFlake& flake : flakes) {
    const double distance_m = glm::distance(glm::dvec3(flake.centre_m), level_view.eye_m);
    if (distance_m > from_m && distance_m <= to_m && frustum.touches(flake.centre_m, 0.0))
      sum_m2 += cross_section_m2(flake, level_view.eye_m);
  }
  const double volume_m3 =
      frustum.solid_angle_sr() / 3.0 * (std::pow(to_m, 3) - std::pow(from_m, 3));
  return sum_m2 / volume_m3 / gunn_marshall(rate_mm_h).extinction_above_per_m(1.0, min_melted_mm);
}

/// Mean of exp(-r / reach) over a shell of space.
double expected_fraction(double reach_m, double from_m, double to_m) {
  const auto integral = [&](double r) {
    const double x = r / reach_m;
    return -std::pow(reach_m, 3) * std::exp(-x) * (x * x + 2.0 * x + 2.0);
  };
  return 3.0 * (integral(to_m) - integral(from_m)) / (std::pow(to_m, 3) - std::pow(from_m, 3));
}

/// Crystals, discs and streaks alike carry the extinction of the sizes that they stand for.
TEST(FallingSnow, DrawnFlakesDimByTheirCrossSections) {
  for (const double rate_mm_h : {0.4, 4.0})
    for (const double shutter_s : {0.0, 0.01}) {
      scene::Scene scene = snowy(rate_mm_h);
      scene.snowfall.shutter_s = shutter_s;
      std::vector<SeenFlake> flakes;
      const int frames = 8;
      for (int frame = 0; frame < frames; ++frame) {
        // Within 3 m of the eye one seed's flakes, a few large ones among them, are off by 5 %.
        scene.seed = static_cast<std::uint64_t>(frame) + 1;
        const SeenFlakes seen = seen_of(scene, 20.0 * frame);
        flakes.insert(flakes.end(), seen.flakes.begin(), seen.flakes.end());
      }
      const Frustum frustum(level_view);
      const double reach_m = near_field(rate_mm_h, frustum.solid_angle_sr(), 30000.0).reach_m;
      for (const double from_m : {1.0, 3.5, 10.0}) {
        const double drawn = drawn_fraction(flakes, rate_mm_h, from_m, 3.0 * from_m) / frames;
        const double expected = expected_fraction(reach_m, from_m, 3.0 * from_m);
        EXPECT_NEAR(drawn, expected, 0.06 * expected) << rate_mm_h << " " << from_m;
      }
    }
}

/// Flakes and fog together dim as the snow does: Beer and Lambert's law for Gunn and Marshall's
/// extinction, 4.982 R^1.05 per km with what is diffracted, half of it as seen.
TEST(FallingSnow, FlakesAndFogDimAsBeerAndLambertSay) {
  for (const double rate_mm_h : {0.4, 1.2, 4.0, 20.0}) {
    const double extinction = 0.5 * 4.982e-3 * std::pow(rate_mm_h, 1.05);
    const SeenFlakes seen = seen_of(snowy(rate_mm_h));
    const Frustum frustum(level_view);
    for (const double fraction_of_visibility : {0.01, 0.1, 0.3, 1.0}) {
      const double length_m = fraction_of_visibility * 3.912 / extinction;
      double depth = seen.fog_extinction_per_m * length_m;
      for (const SeenFlake& flake : seen.flakes) {
        const double distance_m = glm::distance(glm::dvec3(flake.centre_m), level_view.eye_m);
        if (distance_m > length_m || !frustum.touches(flake.centre_m, 0.0)) continue;
        depth += cross_section_m2(flake, level_view.eye_m) /
                 (distance_m * distance_m * frustum.solid_angle_sr());
      }
      EXPECT_NEAR(std::exp(extinction * length_m - depth), 1.0, 0.05)
          << rate_mm_h << " mm/h, " << length_m << " m";
    }
  }
}

/// Flakes first, first + 1, ... of a cube, seen from the world's origin.
FlakeLanes flakes_of(const FlakeMotion& motion, const Population& population, std::uint64_t first,
                     const FlakeMotion::Moment& moment, const PeriodicCube& cube) {
  FlakeMotion::Drifting drifting;
  motion.drift(FlakeMotion::air(population, cube, moment, glm::dvec3(0.0)), first, drifting);
  FlakeLanes flakes;
  motion.fly(drifting, moment, flakes);
  return flakes;
}

/// Water that falls through a level square is the rate: 1 mm/h is 1 kg per m2 and hour. Drops above
/// 0.5 mm hold Gamma(4, Lambda / 2) / 6 of it.
TEST(FlakeMotion, WaterThroughAPlaneIsTheRate) {
  for (const double rate_mm_h : {0.4, 1.0, 4.0}) {
    const scene::Scene scene = snowy(rate_mm_h);
    const FlakeMotion motion(scene, Weather(scene, nullptr), rate_mm_h);
    const SizeDistribution sizes = gunn_marshall(rate_mm_h);
    const double side_m = 6.0;
    const PeriodicCube cube = {{0.0, 0.0, 0.0}, side_m};
    const auto flakes = static_cast<std::uint64_t>(
        std::llround(sizes.number_above_per_m3(min_melted_mm) * std::pow(side_m, 3)));
    const Population population(5, flakes);
    double water_kg = 0.0;
    const double step_s = 0.5, seconds = 6.0;
    for (double time_s = 0.0; time_s < seconds - 0.5 * step_s; time_s += step_s) {
      const auto before = motion.moment(time_s, rate_mm_h);
      const auto after = motion.moment(time_s + step_s, rate_mm_h);
      for (std::uint64_t i = 0; i < flakes; ++i) {
        static FlakeLanes from, to;
        if (i % lanes == 0) {
          from = flakes_of(motion, population, i, before, cube);
          to = flakes_of(motion, population, i, after, cube);
        }
        const double from_z = from.from_eye.z[i % lanes], to_z = to.from_eye.z[i % lanes];
        const double crossed = (from_z > 0.0 ? 1.0 : 0.0) - (to_z > 0.0 ? 1.0 : 0.0);
        if (crossed == 0.0 || std::abs(from_z) > 1.0) continue;  // wrapped round, not crossed
        const double diameter_mm = 1e3 * static_cast<double>(from.diameter[i % lanes]);
        const double melted3_mm3 = 0.17 * diameter_mm * diameter_mm;
        water_kg += crossed * 1e-6 * pi / 6.0 * melted3_mm3;
      }
    }
    const double x = 0.5 * sizes.lambda_per_mm;
    const double fraction = std::exp(-x) * (1.0 + x + x * x / 2.0 + x * x * x / 6.0);
    const double measured_mm_h = water_kg / (side_m * side_m * seconds / 3600.0) / fraction;
    EXPECT_NEAR(measured_mm_h, rate_mm_h, 0.05 * rate_mm_h);
  }
}

/// However long it has snowed.
TEST(FlakeMotion, PlacesMoveAtTheirVelocities) {
  const scene::Scene scene = snowy(1.0);
  const FlakeMotion motion(scene, Weather(scene, nullptr), 1.0);
  const PeriodicCube cube = {{3.0, 4.0, 5.0}, 20.0};
  const double step_s = 2e-3;
  for (const double time_s : {33.0, 1e5})
    for (std::uint64_t first = 0; first < 256; first += lanes) {
      const auto flakes_at = [&](double at_s) {
        return flakes_of(motion, Population(9, 10000), first, motion.moment(at_s, 1.0), cube);
      };
      const FlakeLanes before = flakes_at(time_s - step_s), now = flakes_at(time_s),
                       after = flakes_at(time_s + step_s);
      for (std::size_t i = 0; i < lanes; ++i) {
        const glm::vec3 way = after.from_eye.at(i) - before.from_eye.at(i);
        if (glm::length(way) > 1.0F) continue;  // wrapped round
        const float time_between_s = static_cast<float>(2.0 * step_s);
        EXPECT_NEAR(glm::distance(way / time_between_s, now.velocity.at(i)), 0.0F, 0.01F) << i;
      }
    }
}

/// Each column has a run of flakes, as many as any other, and they are nowhere else.
TEST(FlakeMotion, FlakesAreInTheirColumns) {
  scene::Scene scene = snowy(1.0, scene::WindPattern::steady);
  scene.wind.speed_m_s = 0.0;
  const FlakeMotion motion(scene, Weather(scene, nullptr), 1.0);
  const PeriodicCube cube = {{0.0, 0.0, 0.0}, 8.0};
  const Population population(3, 64 * 200 + 7);
  ASSERT_EQ(population.bits(), 3);
  EXPECT_EQ(population.flakes_before(0), 0u);
  EXPECT_EQ(population.flakes_before(64), population.flakes());
  const auto moment = motion.moment(70.0, 1.0);
  const auto air = FlakeMotion::air(population, cube, moment, glm::dvec3(0.0));
  for (std::uint32_t column = 0; column < 64; ++column) {
    const std::uint64_t first = population.flakes_before(column);
    const std::uint64_t last = population.flakes_before(column + 1);
    EXPECT_NEAR(static_cast<double>(last - first), 200.0, 2.0);
    FlakeMotion::Drifting drifting;
    motion.drift(air, first, drifting);
    for (std::size_t i = 0; i < lanes; ++i) {
      ASSERT_EQ(population.column_of(first + i), column);
      // From the cube's low corner on, where turns begin, which is at its middle.
      const auto cell = [](float place) {
        return static_cast<std::uint32_t>(place < 0.0F ? place + 8.0F : place);
      };
      ASSERT_EQ(cell(drifting.from_eye.x[i]), column % 8);
      ASSERT_EQ(cell(drifting.from_eye.y[i]), column / 8);
    }
  }
}

/// Of the flakes that a view sees, those that a view beside it sees as well are at the same places.
/// A camera that took them with it would share none.
TEST(FallingSnow, StaysWhereItIsWhenTheCameraMoves) {
  scene::Scene scene = snowy(1.0);
  scene.snowfall.flakes = 2000;
  SnowView moved = level_view;
  moved.eye_m += glm::dvec3(0.03, 0.02, 0.01);
  moved.target_m += glm::dvec3(-0.2, 0.1, 0.1);
  const SeenFlakes here = seen_of(scene), there = seen_of(scene, 50.0, moved);
  std::size_t same = 0;
  for (const SeenFlake& flake : here.flakes)
    for (const SeenFlake& other : there.flakes)
      if (glm::distance(flake.centre_m, other.centre_m) < 1e-5F) {
        ++same;
        break;
      }
  EXPECT_GT(static_cast<double>(same), 0.93 * static_cast<double>(here.flakes.size()));
}

TEST(FallingSnow, IsTheSameWithAnyNumberOfThreads) {
  const scene::Scene scene = snowy(1.0);
  const SeenFlakes many = seen_of(scene);
  const ThreadLimit limit(1);
  const SeenFlakes one = seen_of(scene);
  ASSERT_EQ(one.flakes.size(), many.flakes.size());
  EXPECT_EQ(
      std::memcmp(one.flakes.data(), many.flakes.data(), one.flakes.size() * sizeof(SeenFlake)), 0);
}

TEST(FallingSnow, ComesFromTheFarthestToTheNearestAndNotTooNear) {
  const SeenFlakes seen = seen_of(snowy(5.0));
  double last_m = 1e9;
  for (const SeenFlake& flake : seen.flakes) {
    const double distance_m = glm::distance(glm::dvec3(flake.centre_m), level_view.eye_m);
    ASSERT_LE(distance_m, last_m + 1e-4);
    last_m = distance_m;
  }
  EXPECT_GT(last_m, 0.1499);
}

TEST(FallingSnow, EndsAtTheGround) {
  const Heightfield ground(2, 42.0, 1.2F);
  const SeenFlakes seen = seen_of(snowy(1.0), 50.0, level_view, ground);
  ASSERT_GT(seen.flakes.size(), 1000u);
  for (const SeenFlake& flake : seen.flakes) ASSERT_GT(flake.centre_m.z, 1.2F);
}

TEST(FallingSnow, IsNoneInRainOrDryAir) {
  scene::Scene scene = snowy(1.0);
  scene.weather.temperature_c = 4.0;
  EXPECT_TRUE(seen_of(scene).flakes.empty());
  EXPECT_EQ(seen_of(scene).fog_extinction_per_m, 0.0);
  EXPECT_TRUE(seen_of(snowy(0.0)).flakes.empty());
  // High enough it is cold enough.
  SnowView high = level_view;
  high.eye_m.z = high.target_m.z = 2000.0;
  EXPECT_FALSE(seen_of(scene, 50.0, high).flakes.empty());
}

TEST(FallingSnow, NearFlakesAreCrystalsFarOnesDiscsFastOnesStreaks) {
  scene::Scene scene = snowy(1.0);
  scene.snowfall.shutter_s = 0.0;
  for (const SeenFlake& flake : seen_of(scene).flakes) {
    const double distance_m = glm::distance(glm::dvec3(flake.centre_m), level_view.eye_m);
    ASSERT_EQ(flake.picture == pictures().disc(), distance_m > textured_within_m);
  }
  scene.snowfall.shutter_s = 0.02;
  scene.wind.speed_m_s = 12.0;
  scene.wind.heading_deg = 90.0;
  scene.wind.field = scene::WindPattern::steady;
  std::size_t streaks = 0;
  const SeenFlakes fast = seen_of(scene);
  for (const SeenFlake& flake : fast.flakes) {
    if (flake.picture != pictures().streak()) continue;
    ++streaks;
    const glm::vec3 along = glm::normalize(flake.up_m);
    ASSERT_GT(std::abs(along.x), 0.7F);  // east, as the wind
    ASSERT_NEAR(glm::dot(along, glm::normalize(flake.right_m)), 0.0F, 1e-3F);
    ASSERT_LE(flake.opacity, 1.0F);
  }
  EXPECT_GT(static_cast<double>(streaks), 0.9 * static_cast<double>(fast.flakes.size()));
}

TEST(FallingSnow, StaysFiniteInAnyWindAtAnyTime) {
  scene::Scene scene = snowy(50.0);
  scene.wind.speed_m_s = 60.0;
  scene.wind.turbulence = 1.0;
  scene.weather.earlier_h = 1e4;
  scene.snowfall.flakes = 3000;
  const SeenFlakes seen = seen_of(scene, 1e6);
  ASSERT_FALSE(seen.flakes.empty());
  for (const SeenFlake& flake : seen.flakes)
    ASSERT_TRUE(std::isfinite(
        glm::dot(flake.centre_m + flake.right_m + flake.up_m, glm::vec3(flake.opacity))));
}

}  // namespace
}  // namespace wold::snow
