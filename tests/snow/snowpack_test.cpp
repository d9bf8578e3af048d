#include "snow/snowpack.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "snow/snowpack_field.h"

namespace wold::snow {
namespace {

constexpr double open_ground_mm_per_day = 3.51;  // Kuusisto 1980

/// `steps` equal steps of constant weather at the terrain's zero.
Snowpack after(Snowpack pack, const WeatherMoment& weather, double hours, int steps = 1,
               double melt_mm_per_day = open_ground_mm_per_day) {
  const PackStep step = pack_step(weather, 0.0, hours / steps, melt_mm_per_day);
  for (int i = 0; i < steps; ++i) pack = advanced(pack, step);
  return pack;
}

double density_kg_m3(const Snowpack& pack) { return pack.water_mm / pack.depth_m; }

TEST(FreshSnow, HasTheDensitiesOfHedstromAndPomeroy) {
  EXPECT_NEAR(fresh_density_kg_m3(0.0), 119.17, 0.005);
  EXPECT_NEAR(fresh_density_kg_m3(-5.0), 75.36, 0.005);
  EXPECT_NEAR(fresh_density_kg_m3(-10.0), 69.00, 0.005);
  EXPECT_EQ(fresh_density_kg_m3(1.5), 120.0);
}

TEST(Snowpack, GrowsByACentimetreAnHourWhereAMillimetreFallsAt100PerCubicMetre) {
  const double at_100_c = 2.59 * std::log((100.0 - 67.92) / 51.25);
  const Snowpack pack = after({}, {at_100_c, 1.0}, 1.0);
  EXPECT_DOUBLE_EQ(pack.water_mm, 1.0);
  EXPECT_NEAR(pack.depth_m, 0.01, 1e-4);  // less what half an hour settles
}

TEST(Snowpack, SettlesAsPublished) {
  const Snowpack fresh{100.0, 1.0, 0.0};
  constexpr double week_h = 7 * 24.0;
  EXPECT_NEAR(density_kg_m3(after(fresh, {-5.0, 0.0}, week_h)), 213.66, 0.005);
  EXPECT_NEAR(density_kg_m3(after(fresh, {1.0, 0.0}, week_h, 1, 0.0)), 327.32, 0.005);
  const Snowpack firn{400.0, 1.0, 0.0};  // denser than cold snow settles to
  EXPECT_EQ(after(firn, {-5.0, 0.0}, week_h).depth_m, firn.depth_m);
}

TEST(Snowpack, MeltsByDegreeDays) {
  const Snowpack deep{200.0, 0.5, 0.0};
  EXPECT_NEAR(200.0 - after(deep, {5.0, 0.0}, 24.0).water_mm, 17.55, 1e-9);
  const Snowpack thin{10.0, 0.1, 0.0};
  EXPECT_GT(after(thin, {5.0, 0.0}, 0.565 * 24.0).water_mm, 0.0);
  EXPECT_EQ(after(thin, {5.0, 0.0}, 0.575 * 24.0).water_mm, 0.0);
  EXPECT_EQ(after(thin, {5.0, 0.0}, 0.575 * 24.0).depth_m, 0.0);
}

TEST(Snowpack, DarkensAsPublishedAndIsWhiterInVisibleLight) {
  const Snowpack fresh{1e4, 100.0, 0.0};
  const auto albedo = [&](double days) {
    return broadband_albedo(after(fresh, {1.0, 0.0}, 24.0 * days).age);
  };
  EXPECT_NEAR(albedo(1.0), 0.7753, 5e-5);
  EXPECT_NEAR(albedo(5.0), 0.6054, 5e-5);
  EXPECT_NEAR(albedo(10.0), 0.5318, 5e-5);
  EXPECT_DOUBLE_EQ(visible_albedo(0.0), 0.95);
  EXPECT_NEAR(visible_albedo(1.0), 0.76, 1e-12);
}

// Ten millimetres of new snow take an old surface 1 - 1/e of the way to a fresh one (Essery 2015).
TEST(Snowpack, IsRenewedBySnowfall) {
  const Snowpack old = {50.0, 0.2, 1.0};
  const WeatherMoment snowing = {.temperature_c = -5.0, .precipitation_mm_h = 10.0};
  EXPECT_NEAR(advanced(old, pack_step(snowing, 0.0, 1.0, 3.0)).age, std::exp(-1.0), 2e-3);
}

TEST(Snowpack, IsColderAndDeeperHigherUp) {
  const WeatherMoment sleet{2.5, 1.0};
  EXPECT_EQ(pack_step(sleet, 0.0, 1.0, 3.0).snow_mm, 0.0);
  EXPECT_NEAR(pack_step(sleet, 1.5 / lapse_k_per_m, 1.0, 3.0).snow_mm, 0.5, 1e-12);
  EXPECT_NEAR(pack_step(sleet, 3.0 / lapse_k_per_m, 1.0, 3.0).snow_mm, 1.0, 1e-12);
  EXPECT_EQ(pack_step(sleet, 3.0 / lapse_k_per_m, 1.0, 3.0).melt_mm, 0.0);
}

TEST(Snowpack, IsNearlyTheSameHoweverTimeIsDivided) {
  const WeatherMoment snowing{-3.0, 2.0}, thawing{1.2, 0.8};
  for (const WeatherMoment& weather : {snowing, thawing}) {
    const Snowpack start{3.0, 0.03, 0.4};
    const Snowpack whole = after(start, weather, 1.0, 1);
    const Snowpack parts = after(start, weather, 1.0, 64);
    EXPECT_NEAR(whole.water_mm, parts.water_mm, 1e-12);
    EXPECT_NEAR(whole.depth_m, parts.depth_m, 5e-4 * parts.depth_m);
    EXPECT_NEAR(whole.age, parts.age, 1e-12);
  }
}

TEST(Snowpack, LiesOrHasMelted) {
  Snowpack pack{5.0, 0.05, 0.2};
  double fallen_mm = pack.water_mm, melted_mm = 0.0;
  for (int hour = 0; hour < 1000; ++hour) {
    const WeatherMoment weather{8.0 * std::sin(0.1 * hour), 1.0 + std::sin(0.37 * hour)};
    const PackStep step = pack_step(weather, 0.0, 1.0, 3.0);
    const double before_mm = pack.water_mm;
    pack = advanced(pack, step, 1.3);
    fallen_mm += 1.3 * step.snow_mm;
    melted_mm += std::min(before_mm + 1.3 * step.snow_mm, step.melt_mm);
    ASSERT_GE(pack.water_mm, 0.0);
    ASSERT_EQ(pack.water_mm > 0.0, pack.depth_m > 0.0);
  }
  EXPECT_GT(melted_mm, 100.0);
  EXPECT_NEAR(fallen_mm, pack.water_mm + melted_mm, 1e-9 * fallen_mm);
}

TEST(SnowpackField, IsOfTheSamePacksOneByOne) {
  const std::vector<float> heights_m = {0.0F, 1000.0F, 250.0F, 251.0F};
  const std::vector<float> drift = {1.0F, 0.5F, 1.5F, 0.0F};
  const HeightClasses classes(heights_m);
  SnowpackField packs(heights_m.size(), {1.0, 0.01, 0.1});
  const WeatherMoment weather{1.5, 3.0};
  advance(packs, classes, classes.step(weather, 1.0, 3.0), drift, {});
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    const Snowpack expected =
        advanced({1.0, 0.01, 0.1}, pack_step(weather, heights_m[i], 1.0, 3.0), drift[i]);
    EXPECT_NEAR(packs.water_mm[i], expected.water_mm, 1e-12) << i;
    EXPECT_NEAR(packs.depth_m[i], expected.depth_m, 1e-12) << i;
    EXPECT_NEAR(packs.age[i], expected.age, 1e-12) << i;
  }
}

TEST(SnowpackField, RefusesWeatherThatIsNoNumber) {
  const HeightClasses classes(std::vector<float>{0.0F});
  EXPECT_THROW(classes.step({std::nan(""), 1.0}, 1.0, 3.0), InputError);
  EXPECT_THROW(classes.step({0.0, INFINITY}, 1.0, 3.0), InputError);
  EXPECT_THROW(classes.step({0.0, -1.0}, 1.0, 3.0), InputError);
}

}  // namespace
}  // namespace wold::snow
