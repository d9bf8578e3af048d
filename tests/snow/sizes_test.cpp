#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "core/random.h"
#include "snow/fall_speed.h"
#include "snow/flake_sizes.h"
#include "snow/near_field.h"
#include "snow/size_distribution.h"

namespace wold::snow {
namespace {

TEST(SizeDistribution, HasTheNumbersOfGunnAndMarshall) {
  const SizeDistribution sizes = gunn_marshall(1.0);
  EXPECT_NEAR(sizes.number_per_m3(), 1490.0, 1.0);
  EXPECT_NEAR(sizes.number_above_per_m3(0.5), 416.0, 1.0);
  EXPECT_NEAR(sizes.water_g_per_m3(), 0.2823, 1e-4);
}

TEST(SizeDistribution, DimsAsThreeSourcesSay) {
  EXPECT_NEAR(1e3 * gunn_marshall(1.0).extinction_per_m(full_efficiency), 4.982, 1e-3);
  // In all diffracted light, as the storm's rate to the power of 1.05.
  EXPECT_NEAR(1e3 * gunn_marshall(3.0).extinction_per_m(full_efficiency),
              4.982 * std::pow(3.0, 1.05), 0.01);
  // Rasmussen 1999, dry snow: 1.3 x 0.017 g/cm2 x 1 m/s / visibility is the rate.
  const double rate_m_s = 1e-3 / 3600.0, water_kg_m3 = 1000.0;
  const double rasmussen_m = 1.3 * 0.17 * 1.0 / (rate_m_s * water_kg_m3);
  EXPECT_NEAR(visibility_m(gunn_marshall(1.0).extinction_per_m(full_efficiency)), rasmussen_m,
              0.025 * rasmussen_m);
  // Warner and Gunn 1969 by transmission, which hardly loses what is diffracted.
  EXPECT_NEAR(1e3 * gunn_marshall(1.0).extinction_per_m(seen_efficiency), 2.53, 0.06);
}

TEST(SizeDistribution, MeltedDiametersAreHolroyds) {
  EXPECT_NEAR(flake_diameter_mm(1.0), 2.43, 0.01);
  EXPECT_NEAR(flake_diameter_mm(2.0), 6.86, 0.01);
}

TEST(SizeDistribution, PartsAboveASizeAreIntegrals) {
  const SizeDistribution sizes = gunn_marshall(0.7);
  double number = 0.0, extinction = 0.0;
  const double step_mm = 1e-3;
  for (double d = 0.8 + 0.5 * step_mm; d < 12.0; d += step_mm) {
    const double in_step = sizes.n0_per_m3_mm * std::exp(-sizes.lambda_per_mm * d) * step_mm;
    const double diameter_m = 1e-3 * flake_diameter_mm(d);
    number += in_step;
    extinction += in_step * 3.14159265 / 4.0 * diameter_m * diameter_m;
  }
  EXPECT_NEAR(sizes.number_above_per_m3(0.8), number, 1e-4 * number);
  EXPECT_NEAR(sizes.extinction_above_per_m(1.0, 0.8), extinction, 1e-4 * extinction);
}

TEST(SizeDistribution, RefusesNegativeRatesAndNoNumbers) {
  EXPECT_THROW(gunn_marshall(-1.0), std::invalid_argument);
  EXPECT_THROW(gunn_marshall(std::nan("")), std::invalid_argument);
  EXPECT_EQ(gunn_marshall(0.0).number_per_m3(), 0.0);
  EXPECT_EQ(gunn_marshall(0.0).extinction_per_m(2.0), 0.0);
}

TEST(FallSpeed, IsLocatelliAndHobbss) {
  EXPECT_NEAR(fall_speed_m_s(Crystal::aggregate, 5.0), 1.0350, 1e-4);
  EXPECT_NEAR(fall_speed_m_s(Crystal::plate, 2.0), 0.9168, 1e-4);
  EXPECT_EQ(fall_speed_m_s(Crystal::aggregate, 30.0), fall_speed_m_s(Crystal::aggregate, 10.0));
}

TEST(CrystalFractions, SumToOneAndGrowIntoAggregates) {
  for (const double diameter_mm : {0.5, 2.0, 3.0, 9.0}) {
    const auto fractions = crystal_fractions(scene::CrystalChoice::mixed, diameter_mm);
    EXPECT_NEAR(std::accumulate(fractions.begin(), fractions.end(), 0.0), 1.0, 1e-12);
  }
  EXPECT_EQ(crystal_fractions(scene::CrystalChoice::mixed, 1.0)[3], 0.0);
  EXPECT_GT(crystal_fractions(scene::CrystalChoice::mixed, 6.0)[3], 0.7);
  EXPECT_EQ(crystal_fractions(scene::CrystalChoice::column, 1.0)[1], 1.0);
}

/// Melted diameters of keyed flakes follow exp(-Lambda (d - 0.5 mm)): mean 1 / Lambda above 0.5 mm,
/// and 1/e of them larger than that.
TEST(FlakeSizes, AreExponentialAboveTheLeast) {
  const double lambda = gunn_marshall(1.0).lambda_per_mm;
  const FlakeSizes sizes(1.0, scene::CrystalChoice::mixed);
  const std::vector<float> diameters_m = sizes.diameters_m(1.0);
  double sum = 0.0;
  int above = 0;
  const int flakes = 200000;
  for (int i = 0; i < flakes; ++i) {
    const std::uint32_t rank = FlakeSizes::rank(mixed(static_cast<std::uint64_t>(i)));
    const double diameter_mm = 1e3 * static_cast<double>(diameters_m[rank]);
    const double beyond_mm = std::cbrt(0.17 * diameter_mm * diameter_mm) - min_melted_mm;
    sum += beyond_mm;
    above += beyond_mm > 1.0 / lambda ? 1 : 0;
  }
  EXPECT_NEAR(sum / flakes, 1.0 / lambda, 0.01 / lambda);
  EXPECT_NEAR(static_cast<double>(above) / flakes, std::exp(-1.0), 0.01);
}

/// The flakes' speeds stay those that were measured, within their spread.
TEST(FlakeSizes, FallAsMeasuredForTheirSizes) {
  for (const double rate_mm_h : {0.4, 1.2, 4.0}) {
    const FlakeSizes sizes(rate_mm_h, scene::CrystalChoice::aggregate);
    double sum = 0.0, squares = 0.0;
    const int flakes = 20000;
    for (int i = 0; i < flakes; ++i) {
      const double speed = static_cast<double>(FlakeSizes::speed_unit_m_s) *
                           sizes.speed(mixed(static_cast<std::uint64_t>(i)));
      sum += speed;
      squares += speed * speed;
    }
    const double mean = sum / flakes;
    EXPECT_NEAR(mean, 1.0, 0.25) << rate_mm_h;
    EXPECT_NEAR(std::sqrt(squares / flakes - mean * mean), 0.12, 0.03) << rate_mm_h;
  }
}

}  // namespace
}  // namespace wold::snow
