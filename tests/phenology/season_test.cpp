#include "phenology/season.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "phenology/greenness.h"
#include "phenology/ramp.h"
#include "phenology/withering.h"
#include "snowpack/snow_on_ground.h"

namespace wold::phenology {
namespace {

using namespace std::chrono_literals;

TEST(Ramp, IsThatOfTheGrowingSeasonIndex) {
  // Lowest temperature -2 to 5 degrees, day length 36000 to 39600 s (Jolly and others 2005).
  EXPECT_DOUBLE_EQ(ramp(1.5, -2.0, 5.0), 0.5);
  EXPECT_DOUBLE_EQ(ramp(37800.0, 36000.0, 39600.0), 0.5);
  EXPECT_EQ(ramp(-3.0, -2.0, 5.0), 0.0);
  EXPECT_EQ(ramp(6.0, -2.0, 5.0), 1.0);
}

TEST(PotentialEvaporation, IsThatOfHargreaves) {
  // FAO 56, example 20: Lyon in July, 14.8 to 26.6 degrees, Ra 40.6 MJ/m2: 5.0 mm.
  weather::Day day;
  day.tmin_c = 14.8;
  day.tmax_c = 26.6;
  day.top_sun_mj_m2 = 40.6;
  EXPECT_NEAR(potential_evaporation_mm(day), 5.0, 0.05);
}

TEST(SoilWater, LosesNothing) {
  const MeadowParameters meadow;
  SoilWater water;
  double in_mm = 0.0, out_mm = 0.0, drained_mm = 0.0;
  for (int i = 0; i < 3000; ++i) {
    weather::Day day;
    day.tmin_c = 12.0 * std::sin(0.017 * i) - 5.0;
    day.tmax_c = day.tmin_c + 12.0;
    day.precipitation_mm = std::max(0.0, 20.0 * std::sin(1.7 * i) - 10.0);
    const SoilWater::Loss loss = water.advance(day, potential_evaporation_mm(day), 0.6, meadow);
    in_mm += day.precipitation_mm;
    out_mm += loss.evaporated_mm + loss.drained_mm;
    drained_mm += loss.drained_mm;
    ASSERT_GE(water.soil_mm, 0.0);
    ASSERT_LE(water.soil_mm, meadow.capacity_mm);
  }
  EXPECT_GT(drained_mm, 100.0);
  EXPECT_NEAR(in_mm, water.soil_mm + water.snow_mm + out_mm, 1e-9 * in_mm);
}

// Where warmth and water allow all, greenness grows by a fifth of what lacks in a day, a dead
// meadow's by three tenths of that; in the dark it loses 15 % in a day.
TEST(Greenness, GrowsAndDecaysAtItsRates) {
  std::vector<weather::Day> days(120);
  for (std::size_t i = 0; i < days.size(); ++i) {
    days[i].date = std::chrono::sys_days(2004y / 5 / 1) + std::chrono::days(i);
    days[i].tmin_c = 15.0;
    days[i].tmax_c = 25.0;
    days[i].precipitation_mm = 20.0;
    days[i].top_sun_mj_m2 = 35.0;
    days[i].day_length_h = i < 60 ? 14.0 : 8.0;
  }
  const std::vector<double> green = greenness(days);
  for (std::size_t i = 1; i < 20; ++i)
    EXPECT_NEAR(green[i] - green[i - 1], 0.2 * (0.3 + 0.7 * green[i - 1]) * (1.0 - green[i - 1]),
                1e-9);
  EXPECT_GT(green[59], 0.99);
  for (std::size_t i = 60; i < 120; ++i) EXPECT_NEAR(green[i] / green[i - 1], 0.85, 1e-9);
}

TEST(SnowLayer, LosesNothing) {
  const snowpack::SnowParameters snow;
  snowpack::SnowLayer layer(snow);
  double in_mm = 0.0, out_mm = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const double temperature_c = 8.0 * std::sin(0.13 * i) + 6.0 * std::sin(0.003 * i);
    const double fallen_mm = std::max(0.0, std::sin(0.7 * i));
    const snowpack::SnowLayer::Air air{.temperature_c = temperature_c,
                                       .snow_mm = temperature_c < 1.0 ? fallen_mm : 0.0,
                                       .rain_mm = temperature_c < 1.0 ? 0.0 : fallen_mm,
                                       .sun_w_m2 = 200.0};
    out_mm += layer.advance(air, 3.0);
    in_mm += fallen_mm;
    ASSERT_GE(layer.water_mm(), 0.0);
    ASSERT_EQ(layer.water_mm() > 0.0, layer.depth_m() > 0.0);
    ASSERT_LE(layer.density_kg_m3(), 600.0 + 1e-9);
  }
  EXPECT_GT(out_mm, 300.0);
  EXPECT_NEAR(in_mm, layer.water_mm() + out_mm, 1e-9 * in_mm);
}

TEST(SnowLayer, MeltsByTheHeatThatItGets) {
  // 334 W/m2 for 1000 s melt 1 kg/m2: 100 mm of ice at zero, at 10 degrees without sun.
  const snowpack::SnowParameters snow{
      .longwave_loss_w_m2 = 0.0, .exchange_w_m2_k = 33.4, .held_water = 0.0};
  snowpack::SnowLayer layer(snow);
  layer.advance({.temperature_c = 0.0, .snow_mm = 100.0}, 1.0);
  EXPECT_NEAR(layer.depth_m(), 100.0 / 109.0, 0.02);
  const double left_mm = layer.advance({.temperature_c = 10.0}, 1000.0 / 3600.0 * 20.0);
  EXPECT_NEAR(left_mm, 20.0, 1e-9);
}

// Fresh snow sends back 85 % of the sun's light, old snow half of it (Essery 2015): of 334 W/m2 the
// rest melts 0.15 or 0.5 kg/m2 in 1000 s.
TEST(SnowLayer, MeltsByTheLightThatItKeeps) {
  const snowpack::SnowParameters snow{
      .longwave_loss_w_m2 = 0.0, .exchange_w_m2_k = 0.0, .held_water = 0.0};
  const snowpack::SnowStep step = snowpack::snow_step({.sun_w_m2 = 334.0}, 1000.0 / 3600.0, snow);
  for (const auto& [age, melts_mm] : {std::pair(0.0, 0.15), std::pair(1.0, 0.5)}) {
    snowpack::SnowState lying{.water_mm = 100.0, .depth_m = 0.3, .age = age};
    EXPECT_NEAR(snowpack::advance(lying, step, 1.0, step.sun_mm, snow), melts_mm, 1e-3);
  }
}

TEST(SnowLayer, SettlesByAndersonsLaw) {
  // Published for 200 kg/m3 under 50 kg/m2 at -5 degrees in an hour: +0.3379 kg/m3. A layer feels
  // half its own weight, and deep snow none of the cold, which is worth less than a tenth.
  const snowpack::SnowParameters snow{
      .viscosity_pa_s = 3.7e7, .longwave_loss_w_m2 = 0.0, .held_water = 0.0};
  const auto density_after = [&](double hours) {
    snowpack::SnowLayer layer(snow);
    layer.advance({.temperature_c = 0.0, .snow_mm = 100.0}, 1e-6);
    for (double hour = 0.0; hour < hours; hour += 1.0) layer.advance({.temperature_c = -5.0}, 1.0);
    return layer.density_kg_m3();
  };
  double hours = 0.0;
  while (density_after(hours) < 200.0) hours += 1.0;
  const double cold_c = -5.0 * std::exp(-1.0), density = density_after(hours);
  const double rate = density * (9.81 * 50.0 / (3.7e7 * std::exp(-cold_c / 12.4 + density / 55.6)) +
                                 2.8e-6 * std::exp(cold_c / 23.8 - (density - 150.0) / 21.7));
  EXPECT_NEAR(density_after(hours + 1.0) - density, 3600.0 * rate, 0.01);
}

TEST(WeatheringDegree, HasTheGreennessOfPictures) {
  EXPECT_DOUBLE_EQ(greenness_of(0.0), 1.0);
  EXPECT_DOUBLE_EQ(greenness_of(1.0), 0.0);
  // Green chromatic coordinates of examples/hillside.toml, scaled.
  EXPECT_NEAR(greenness_of(0.3), (0.392 - 0.331) / (0.418 - 0.331), 0.03);
  EXPECT_NEAR(greenness_of(0.6), (0.356 - 0.331) / (0.418 - 0.331), 0.03);
  for (double degree = 0.0; degree <= 1.0; degree += 0.125)
    EXPECT_NEAR(weathering_degree_of(greenness_of(degree)), degree, 1e-9);
}

TEST(WeatheringDegree, NeverFallsBackInAutumnAndFallsWithNewGrowth) {
  std::vector<double> green;
  for (int day = 0; day < 100; ++day)  // autumn, with warm days that change little
    green.push_back(0.9 - 0.009 * day + 0.02 * std::sin(0.9 * day));
  for (int day = 0; day < 100; ++day) green.push_back(0.0);
  for (int day = 0; day < 100; ++day) green.push_back(0.007 * day);
  const std::vector<double> degrees = weathering_degrees(green);
  EXPECT_TRUE(std::is_sorted(degrees.begin(), degrees.begin() + 200));
  EXPECT_GT(degrees[199], 0.99);
  EXPECT_TRUE(std::is_sorted(degrees.rbegin(), degrees.rbegin() + 100));
  EXPECT_NEAR(greenness_of(degrees.back()), green.back(), 1e-9);
  for (std::size_t day = 1; day < degrees.size(); ++day)
    EXPECT_LT(std::abs(degrees[day] - degrees[day - 1]), 0.2) << day;
}

TEST(Season, OfOneDayIsOneDay) {
  weather::Day day;
  day.date = std::chrono::sys_days(2004y / 9 / 1);
  day.tmin_c = 8.0;
  day.tmax_c = 18.0;
  const std::vector<weather::Day> days = {day};
  const std::vector<SeasonDay> season = season_of(days);
  ASSERT_EQ(season.size(), 1U);
  EXPECT_EQ(season[0].snow_depth_m, 0.0);
  EXPECT_TRUE(season_of({}).empty());
}

}  // namespace
}  // namespace wold::phenology
