#include "snowpack/snow_forcing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "snowpack/decay.h"
#include "weather/day_length.h"

namespace wold::snowpack {
namespace {

TEST(Decay, IsTheExponential) {
  for (double x = 0.0; x < 600.0; x = x * 1.01 + 1e-4)
    ASSERT_NEAR(decay(x), std::exp(-x), 1e-11 * std::exp(-x)) << x;
  EXPECT_EQ(decay(0.0), 1.0);
  EXPECT_LT(decay(1e9), 1e-299);
}

weather::Day day_of(std::chrono::sys_days date, double tmin_c, double tmax_c) {
  const int number = weather::day_of_year(date);
  weather::Day day;
  day.date = date;
  day.tmin_c = tmin_c;
  day.tmax_c = tmax_c;
  day.precipitation_mm = 12.0;
  day.day_length_h = weather::day_length_h(number, 46.0);
  day.top_sun_mj_m2 = weather::extraterrestrial_mj_m2(number, 46.0);
  return day;
}

constexpr std::chrono::sys_days march(std::chrono::year(2026) / 3 / 1);

TEST(DailyForcing, SwingsFromMorningToMorning) {
  const DailyForcing air(day_of(march, -6.0, 4.0), day_of(march, -2.0, 4.0), 46.0);
  EXPECT_DOUBLE_EQ(air.temperature_c(6.0), -6.0);
  EXPECT_DOUBLE_EQ(air.temperature_c(10.5), -1.0);
  EXPECT_DOUBLE_EQ(air.temperature_c(15.0), 4.0);
  EXPECT_DOUBLE_EQ(air.temperature_c(30.0), -2.0);
  EXPECT_DOUBLE_EQ(air.sky(9.0).phase_c, 1.0);
  EXPECT_DOUBLE_EQ(air.precipitation_mm_h(), 0.5);
  EXPECT_DOUBLE_EQ(air.falling_mm_h(), 0.5);  // all day long, as its wet_h says
}

// Hargreaves: 0.16 sqrt(9 K) of what comes to the air's top, at night none.
TEST(DailyForcing, HasTheSunOfItsDate) {
  const weather::Day day = day_of(march, -4.0, 5.0);
  const DailyForcing air(day, day, 46.0);
  double sum_j_m2 = 0.0;
  for (double hour = 6.005; hour < 30.0; hour += 0.01) sum_j_m2 += 36.0 * air.sky(hour).sun_w_m2;
  EXPECT_NEAR(sum_j_m2 * 1e-6, 0.48 * day.top_sun_mj_m2, 1e-3 * day.top_sun_mj_m2);
  EXPECT_EQ(air.sky(24.0).sun_w_m2, 0.0);
  EXPECT_DOUBLE_EQ(air.sky(9.0).clearness, 0.64);
}

// Erbs, Klein and Duffie: 0.71 of the light is diffuse where 0.48 of it comes through.
TEST(DailyForcing, LightsSlopesByTheAngleOfTheSun) {
  const weather::Day day = day_of(march, -4.0, 5.0);
  const DailyForcing air(day, day, 46.0);
  const SkyForcing noon = air.sky(12.0), morning = air.sky(9.0);
  const double k = 0.48;
  const double diffuse =
      0.9511 - 0.1604 * k + 4.388 * k * k - 16.638 * std::pow(k, 3) + 12.336 * std::pow(k, 4);
  EXPECT_NEAR(noon.diffuse_w_m2, diffuse * noon.sun_w_m2, 1e-9);
  const double sun_height = M_PI / 2.0 - 46.0 * M_PI / 180.0 + weather::declination_rad(60);
  EXPECT_NEAR(noon.slant_east_w_m2, 0.0, 1e-9);
  EXPECT_NEAR(noon.slant_north_w_m2, -(noon.sun_w_m2 - noon.diffuse_w_m2) / std::tan(sun_height),
              1e-9);
  EXPECT_GT(morning.slant_east_w_m2, 0.0);

  const SnowStep step = snow_step(snow_forcing(0.0, 0.0, noon), 3.0);
  const double direct_mm = step.sun_mm - step.diffuse_mm;
  EXPECT_EQ(sun_mm(step, 0.0, 0.0), step.sun_mm);
  const double square = 1.0 / std::tan(sun_height);  // to the sun: falls to the south
  EXPECT_NEAR(sun_mm(step, 0.0, square),
              step.diffuse_mm + direct_mm / std::pow(std::sin(sun_height), 2), 1e-9);
  EXPECT_NEAR(sun_mm(step, 0.0, -2.0), step.diffuse_mm, 1e-9);  // turned away
}

// Under thick clouds, 0.16 of the light, nearly all of it is diffuse: 1 - 0.09 k.
TEST(DailyForcing, IsDiffuseUnderClouds) {
  const weather::Day day = day_of(march, 1.0, 2.0);
  const SkyForcing noon = DailyForcing(day, day, 46.0).sky(12.0);
  EXPECT_NEAR(noon.diffuse_w_m2, (1.0 - 0.09 * 0.16) * noon.sun_w_m2, 1e-9);
}

// A sun 45 degrees high in the east: ground that falls that way by 45 degrees is square to it and
// gets twice as much per level area, ground that rises so steeply is grazed.
TEST(SunOnSlopes, ComesFromWhereTheSunIs) {
  const SnowStep morning{.sun_mm = 1.0, .slant_east_mm = 1.0};
  EXPECT_DOUBLE_EQ(sun_mm(morning, -1.0, 0.0), 2.0);
  EXPECT_DOUBLE_EQ(sun_mm(morning, 1.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(sun_mm(morning, 0.0, 1.0), 1.0);
}

TEST(SnowForcing, IsSnowOrRainByTheDaysTemperature) {
  SkyForcing sky;
  sky.phase_c = 1.0;
  EXPECT_EQ(snow_forcing(-3.0, 2.0, sky).rain_mm, 2.0);
  const SnowForcing higher = snow_forcing(-3.0, 2.0, sky, 1.0 - SnowParameters{}.half_snow_c);
  EXPECT_DOUBLE_EQ(higher.snow_mm, 1.0);
  EXPECT_DOUBLE_EQ(higher.rain_mm, 1.0);
  EXPECT_EQ(snow_fraction(all_snow_c), 1.0);
}

}  // namespace
}  // namespace wold::snowpack
