#include "snow/raindrops.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "snow/falling_snow.h"
#include "snow/wet_ground.h"

namespace wold::snow {
namespace {

constexpr double pi = std::numbers::pi;

const FlakePictures& pictures() {
  static const FlakePictures made(1);
  return made;
}

scene::Scene rainy(double rate_mm_h) {
  scene::Scene scene;
  scene.weather.temperature_c = 12.0;
  scene.weather.precipitation_mm_h = rate_mm_h;
  scene.wind.field = scene::WindPattern::steady;
  scene.wind.speed_m_s = 2.0;
  scene.wind.heading_deg = 90.0;
  return scene;
}

const SnowView view = {
    .eye_m = {21.0, 2.0, 1.6}, .target_m = {21.0, 20.0, 1.6}, .width_px = 640, .height_px = 360};

SeenFlakes seen_of(const scene::Scene& scene, const SnowView& from = view) {
  static const Heightfield ground(2, 42.0, -1e6F);
  return FallingSnow(scene, Weather(scene, nullptr), pictures(), Falling::rain)
      .at(50.0, from, ground);
}

/// A drop's cross-section is what it hides of what lies behind, whatever the streak.
double cross_section_m2(const SeenFlake& drop) {
  const glm::dvec3 area = 4.0 * glm::cross(glm::dvec3(drop.right_m), glm::dvec3(drop.up_m));
  const glm::dvec3 to_eye = glm::normalize(view.eye_m - glm::dvec3(drop.centre_m));
  return static_cast<double>(drop.opacity * pictures().mean_opacity(drop.picture)) *
         std::abs(glm::dot(area, to_eye));
}

double distance_m(const SeenFlake& drop) {
  return glm::distance(glm::dvec3(drop.centre_m), view.eye_m);
}

TEST(Raindrops, HaveTheNumbersOfMarshallAndPalmer) {
  // N(d) dd at 1, 5 and 25 mm/h, as their figure 2 has it: 8000 exp(-4.1 R^-0.21 d).
  for (const double rate_mm_h : {1.0, 5.0, 25.0}) {
    const SizeDistribution drops = marshall_palmer(rate_mm_h);
    const double lambda = 4.1 * std::pow(rate_mm_h, -0.21);
    EXPECT_NEAR(drops.number_above_per_m3(2.0) - drops.number_above_per_m3(2.001),
                8000.0 * std::exp(-lambda * 2.0005) * 1e-3, 1e-6);
  }
  EXPECT_EQ(marshall_palmer(0.0).number_per_m3(), 0.0);
  EXPECT_THROW(marshall_palmer(-1.0), std::invalid_argument);
  EXPECT_THROW(marshall_palmer(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

/// Gunn and Kinzer 1949, table 2.
TEST(Raindrops, FallAsGunnAndKinzerMeasured) {
  for (const auto& [diameter_mm, speed_m_s] :
       {std::pair{1.0, 4.03}, {1.6, 5.65}, {2.0, 6.49}, {3.0, 8.06}, {4.0, 8.83}, {5.0, 9.09}})
    EXPECT_NEAR(drop_speed_m_s(diameter_mm), speed_m_s, 0.02 * speed_m_s) << diameter_mm;
  EXPECT_EQ(drop_speed_m_s(0.05), 0.0);
}

/// The water of all drops times their speeds is the rate that they were counted at: the integral of
/// pi / 6 d^3 v(d) N(d), within the fifth that Marshall and Palmer's fit leaves.
TEST(Raindrops, CarryTheRateOfRain) {
  for (const double rate_mm_h : {1.0, 5.0, 20.0}) {
    const SizeDistribution drops = marshall_palmer(rate_mm_h);
    constexpr double step_mm = 0.01;
    double flux_mm3_m2_s = 0.0;
    for (double d = 0.5 * step_mm; d < 12.0; d += step_mm)
      flux_mm3_m2_s += step_mm * pi / 6.0 * d * d * d * drop_speed_m_s(d) * drops.n0_per_m3_mm *
                       std::exp(-drops.lambda_per_mm * d);
    EXPECT_NEAR(flux_mm3_m2_s * 1e-6 * 3600.0, rate_mm_h, 0.2 * rate_mm_h);
  }
}

/// Atlas 1953 (Optical extinction by rainfall): one sees 11.6 km R^-0.63 in widespread rain.
TEST(Raindrops, DimAsAtlasSays) {
  for (const double rate_mm_h : {1.0, 4.0, 10.0}) {
    const double atlas_m = 11.6e3 * std::pow(rate_mm_h, -0.63);
    EXPECT_NEAR(visibility_m(rain_extinction_per_m(rate_mm_h, full_efficiency)), atlas_m,
                0.1 * atlas_m);
  }
  // Parts above a size are integrals.
  const SizeDistribution drops = marshall_palmer(3.0);
  double sum = 0.0;
  constexpr double step_mm = 1e-3;
  for (double d = 1.0 + 0.5 * step_mm; d < 15.0; d += step_mm)
    sum +=
        step_mm * pi / 4.0 * d * d * 1e-6 * drops.n0_per_m3_mm * std::exp(-drops.lambda_per_mm * d);
  EXPECT_NEAR(rain_extinction_above_per_m(drops, 1.0, 1.0), sum, 1e-6 * sum);
}

/// Streaks are as wide as their drops and as long as these fall while the picture is exposed: from
/// both follows the diameter, and its numbers are Marshall and Palmer's, in the heaviest rain of a
/// table as in any other.
TEST(FallingRain, StreaksHaveTheDiametersAndLengthsOfTheirDrops) {
  constexpr double shutter_s = 0.01;
  SnowView fine = view;  // drops are wider than a pixel
  fine.width_px = 4 * view.width_px;
  fine.height_px = 4 * view.height_px;
  for (const double rate_mm_h : {2.0, 10.0}) {
    std::array<double, 4> counted = {};  // 0.5 to 1, 1 to 1.5, ... mm
    double seen_m3 = 0.0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      scene::Scene scene = rainy(rate_mm_h);
      scene.seed = seed;
      scene.rainfall.shutter_s = shutter_s;
      const double nearest_m = 0.2, farthest_m = 0.45;  // where nearly all are drawn
      const Frustum frustum(view);
      seen_m3 +=
          frustum.solid_angle_sr() / 3.0 * (std::pow(farthest_m, 3) - std::pow(nearest_m, 3));
      for (const SeenFlake& drop : seen_of(scene, fine).flakes) {
        if (!frustum.touches(drop.centre_m, 0.0)) continue;
        if (distance_m(drop) < nearest_m || distance_m(drop) > farthest_m) continue;
        ASSERT_EQ(drop.picture, pictures().streak());
        const double diameter_mm = 2e3 * static_cast<double>(glm::length(drop.right_m));
        const double way_m = 2.0 * static_cast<double>(glm::length(drop.up_m)) - 1e-3 * diameter_mm;
        const glm::dvec3 velocity(2.0, 0.0, -drop_speed_m_s(diameter_mm));
        const glm::dvec3 ahead = glm::normalize(glm::dvec3(drop.centre_m) - view.eye_m);
        const double across_m_s = glm::length(velocity - glm::dot(velocity, ahead) * ahead);
        ASSERT_NEAR(way_m, shutter_s * across_m_s, 0.01 * way_m) << diameter_mm << " mm";
        const auto bin = static_cast<std::size_t>((diameter_mm - 0.5) / 0.5);
        if (bin < counted.size()) counted[bin] += 1.0;
      }
    }
    const SizeDistribution drops = marshall_palmer(rate_mm_h);
    for (std::size_t bin = 0; bin < counted.size(); ++bin) {
      const double from_mm = 0.5 + 0.5 * static_cast<double>(bin);
      const double expected =
          seen_m3 * (drops.number_above_per_m3(from_mm) - drops.number_above_per_m3(from_mm + 0.5));
      EXPECT_NEAR(counted[bin], expected, 4.0 * std::sqrt(expected) + 0.1 * expected)
          << rate_mm_h << " mm/h from " << from_mm << " mm";
    }
  }
}

/// In a lighter rain of a film there are as many drops of each size as in any rain of that rate.
TEST(FallingRain, OfALighterHourIsMarshallAndPalmersToo) {
  scene::Scene heavy = rainy(20.0);
  const FlakeMotion motion(heavy, Weather(heavy, nullptr), 20.0, Falling::rain);
  const FlakeMotion::Moment light = motion.moment(5.0, 2.0);
  double there = 0.0, there_above_2_mm = 0.0, all = 0.0;
  for (std::uint64_t i = 0; i < 2000000; ++i) {
    const std::uint64_t key = random_bits({7, key_of("drop"), i, 0});
    const float diameter_m = light.diameters_m[FlakeSizes::rank(key)];
    all += 1.0;
    if (!motion.is_there(key, diameter_m, light)) continue;
    there += 1.0;
    there_above_2_mm += diameter_m > 0.002F ? 1.0 : 0.0;
  }
  const SizeDistribution at_20 = marshall_palmer(20.0), at_2 = marshall_palmer(2.0);
  const double fraction = at_2.number_above_per_m3(0.5) / at_20.number_above_per_m3(0.5);
  EXPECT_NEAR(there / all, fraction, 0.01 * fraction);
  const double large = at_2.number_above_per_m3(2.0) / at_2.number_above_per_m3(0.5);
  EXPECT_NEAR(there_above_2_mm / there, large, 0.08 * large);
}

/// Drops and fog together dim as rain does: Beer and Lambert's law, as seen.
TEST(FallingRain, DropsAndFogDimAsBeerAndLambertSay) {
  for (const double rate_mm_h : {1.0, 10.0, 40.0}) {
    const double extinction = rain_extinction_per_m(rate_mm_h, seen_efficiency);
    const SeenFlakes seen = seen_of(rainy(rate_mm_h));
    const Frustum frustum(view);
    for (const double length_m : {10.0, 100.0, 1000.0}) {
      double depth = seen.fog_extinction_per_m * length_m;
      for (const SeenFlake& drop : seen.flakes)
        if (distance_m(drop) <= length_m && frustum.touches(drop.centre_m, 0.0))
          depth +=
              cross_section_m2(drop) / (std::pow(distance_m(drop), 2) * frustum.solid_angle_sr());
      EXPECT_NEAR(std::exp(extinction * length_m - depth), 1.0, 0.05) << rate_mm_h << " mm/h";
    }
  }
}

TEST(FallingRain, LeansWithTheWindAndIsNoneInFrost) {
  int streaks = 0;
  for (const SeenFlake& drop : seen_of(rainy(5.0)).flakes) {
    const glm::dvec3 ahead = glm::normalize(glm::dvec3(drop.centre_m) - view.eye_m);
    if (drop.picture != pictures().streak() || std::abs(ahead.x) > 0.2) continue;
    ++streaks;
    const glm::vec3 along = glm::normalize(drop.up_m);
    ASSERT_GT(std::abs(along.z), 0.4F);
    ASSERT_LT(along.x * along.z, 0.0F) << "to the east while it falls";
  }
  EXPECT_GT(streaks, 1000);
  scene::Scene frost = rainy(5.0);
  frost.weather.temperature_c = -3.0;
  EXPECT_TRUE(seen_of(frost).flakes.empty());
  EXPECT_EQ(seen_of(frost).fog_extinction_per_m, 0.0);
}

/// R tau (1 - exp(-t / tau)) of water lies after t of rain, and dries to 1/e in each tau.
TEST(WetGround, TakesUpRainAndDries) {
  constexpr double tau_h = 3.0, soaked_mm = 0.5;
  scene::Scene scene = rainy(0.2);
  scene.weather.earlier_h = 1.0;
  const Weather weather(scene, nullptr);
  EXPECT_EQ(ground_wetness(weather, -3600.0, 0.0), 0.0);
  for (const double hours : {0.0, 0.5, 4.0}) {
    const double water_mm = 0.2 * tau_h * (1.0 - std::exp(-(1.0 + hours) / tau_h));
    EXPECT_NEAR(ground_wetness(weather, hours * 3600.0, 0.0), 1.0 - std::exp(-water_mm / soaked_mm),
                1e-9);
  }
  scene.weather.temperature_c = -5.0;
  EXPECT_EQ(ground_wetness(Weather(scene, nullptr), 3600.0, 0.0), 0.0) << "snow wets nothing";
}

/// A film of water over a Lambertian ground, followed by hand: of what the ground sends up, p comes
/// back and is sent up again, and so on.
TEST(WetGround, IsAsDarkAsLekerAndDorfSay) {
  const double p = 1.0 - (1.0 - 0.066) / (1.33 * 1.33);
  for (const double dry : {0.0, 0.13, 0.5, 0.9}) {
    double inside = 0.98 * dry, out = 0.0;
    for (int bounce = 0; bounce < 400; ++bounce) {
      out += (1.0 - p) * inside;
      inside *= p * dry;
    }
    EXPECT_NEAR(wet_albedo(dry), out, 1e-12);
  }
  EXPECT_NEAR(wet_albedo(0.13) / 0.13, 0.55, 0.01);  // moist soil is half as bright as dry
}

}  // namespace
}  // namespace wold::snow
