#include "snow/raindrops.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/elementary.h"

namespace wold::snow {

SizeDistribution marshall_palmer(double rate_mm_h) {
  if (!(rate_mm_h >= 0.0) || !std::isfinite(rate_mm_h))
    throw std::invalid_argument(
        fmt::format("a rate of rain is at least 0 mm/h, got {}", rate_mm_h));
  if (rate_mm_h == 0.0) return {};
  return {8000.0, 4.1 * math::pow(rate_mm_h, -0.21)};
}

double rain_extinction_above_per_m(const SizeDistribution& drops, double efficiency,
                                   double diameter_mm) {
  constexpr double m2_per_mm2 = 1e-6;
  const double x = drops.lambda_per_mm * diameter_mm;
  const double second_moment_above = math::exp(-x) * (1.0 + x + x * x / 2.0);
  return efficiency * std::numbers::pi / 2.0 * drops.n0_per_m3_mm /
         math::pow(drops.lambda_per_mm, 3) * second_moment_above * m2_per_mm2;
}

double rain_extinction_per_m(double rate_mm_h, double efficiency) {
  return rain_extinction_above_per_m(marshall_palmer(rate_mm_h), efficiency, 0.0);
}

double drop_speed_m_s(double diameter_mm) {
  return std::max(0.0, 9.65 - 10.3 * math::exp(-0.6 * diameter_mm));
}

}  // namespace wold::snow
