#include <gtest/gtest.h>

#include "season/greenness.h"
#include "support/measured_days.h"

namespace wold::season {
namespace {

/// What was held out when the parameters were fitted (tests/benchmark/fit_season.cpp).
constexpr int held_out_year = 2012;
bool is_held_out_winter(const Day& day) {
  return test::in_winter(day) && test::year_of(day, true) % 2 == 0;
}

class Measured : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(test::measured_file(snow_place)))
      GTEST_SKIP() << test::measured_file(snow_place)
                   << " is not there: no season is held against what was measured";
  }
  static constexpr const char* snow_place = "col_de_porte_1993_2004";
};

TEST_F(Measured, GreennessOfGrasslandsThatWasHeldOut) {
  double sum = 0.0;
  for (const std::string& name : test::grasslands()) {
    const test::MeasuredDays place = test::measured_days(name, "greenness", 0.0);
    const test::Fit fit = fit_of(place, greenness(place.days), [](const Day& day) {
      return test::year_of(day) == held_out_year;
    });
    EXPECT_GT(fit.count, 60) << name;
    EXPECT_GT(fit.efficiency(), 0.65) << name;
    sum += fit.efficiency();
  }
  EXPECT_GT(sum / static_cast<double>(test::grasslands().size()), 0.83);
}

TEST_F(Measured, DepthOfSnowInWintersThatWereHeldOut) {
  const test::MeasuredDays place = test::measured_days(snow_place, "snow_depth_m", 45.3);
  const std::vector<double> depths_m = test::depths_m(place.days);
  const test::Fit fit = fit_of(place, depths_m, is_held_out_winter);
  EXPECT_GT(fit.count, 800);
  EXPECT_LT(fit.rmse(), 0.19);
  EXPECT_GT(fit.efficiency(), 0.8);
}

}  // namespace
}  // namespace wold::season
