#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "phenology/greenness.h"
#include "support/measured_days.h"

namespace wold::phenology {
namespace {

/// What was held out when the parameters were fitted (tests/benchmark/fit_season.cpp).
constexpr int held_out_year = 2012;
bool is_held_out_winter(const weather::Day& day) {
  return test::in_winter(day) && test::year_of(day, true) % 2 == 0;
}

constexpr const char* snow_place = "col_de_porte_1993_2004";

/// Snow is held against a table whose licence keeps it out of the repository.
class MeasuredSnow : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(test::measured_file(snow_place)))
      GTEST_SKIP() << test::measured_file(snow_place)
                   << " is not there, since its licence forbids some uses: no winter is held "
                      "against what was measured; see tests/data/README.md";
  }
  static test::MeasuredDays measured(const char* column) {
    return test::measured_days(snow_place, column, 45.3);
  }
};

// The goal at places that were left out, 0.69, is fit_season's.
TEST(Measured, GreennessOfGrasslandsThatWasHeldOut) {
  double sum = 0.0;
  for (const std::string& name : test::grasslands()) {
    const test::MeasuredDays place = test::measured_days(name, "greenness", 0.0);
    const test::Fit fit = fit_of(place, greenness(place.days), [](const weather::Day& day) {
      return test::year_of(day) == held_out_year;
    });
    EXPECT_GT(fit.count, 60) << name;
    EXPECT_GT(fit.efficiency(), 0.65) << name;
    sum += fit.efficiency();
  }
  EXPECT_GT(sum / static_cast<double>(test::grasslands().size()), 0.83);
}

// The goal is 0.10 m: docs/measurements.md says by how much it is missed.
TEST_F(MeasuredSnow, DepthInWintersThatWereHeldOut) {
  const test::MeasuredDays place = measured("snow_depth_m");
  const auto depths_m = test::modelled_snow(place.days, &snowpack::SnowOnGround::depth_m);
  const test::Fit fit = fit_of(place, depths_m, is_held_out_winter);
  EXPECT_GT(fit.count, 800);
  EXPECT_LT(fit.rmse(), 0.19);
  EXPECT_GT(fit.efficiency(), 0.8);
}

// Weighed in pits, about every ten days.
TEST_F(MeasuredSnow, WaterInWintersThatWereHeldOut) {
  const test::MeasuredDays place = measured("swe_pit_mm");
  const auto water_mm = test::modelled_snow(place.days, &snowpack::SnowOnGround::water_mm);
  const test::Fit fit = fit_of(place, water_mm, is_held_out_winter);
  EXPECT_GT(fit.count, 60);
  EXPECT_LT(fit.rmse(), 95.0);
  EXPECT_GT(fit.efficiency(), 0.6);
}

TEST_F(MeasuredSnow, IsGoneOnTheDay) {
  const test::MeasuredDays place = measured("snow_depth_m");
  const auto depths_m = test::modelled_snow(place.days, &snowpack::SnowOnGround::depth_m);
  double days_off = 0.0;
  int winters = 0;
  for (int year = 1993; year < 2004; ++year) {
    const auto measured = test::last_snow(place.days, place.measured, year);
    const auto modelled = test::last_snow(place.days, depths_m, year);
    ASSERT_TRUE(measured && modelled) << year;
    days_off += std::abs(static_cast<double>((*modelled - *measured).count()));
    ++winters;
  }
  EXPECT_LT(days_off / winters, 8.0);
}

}  // namespace
}  // namespace wold::phenology
