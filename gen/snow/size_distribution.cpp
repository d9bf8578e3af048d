#include "snow/size_distribution.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/elementary.h"

namespace wold::snow {
namespace {

using std::numbers::pi;
constexpr double holroyd_g_mm_per_cm3 = 0.17;

/// Gamma(4, x) / 6: the fraction of the third moment of exp(-x) that lies above x.
double third_moment_above(double x) {
  return math::exp(-x) * (1.0 + x + x * x / 2.0 + x * x * x / 6.0);
}

}  // namespace

double SizeDistribution::number_above_per_m3(double melted_mm) const {
  return number_per_m3() * math::exp(-lambda_per_mm * melted_mm);
}

double SizeDistribution::water_g_per_m3() const {
  constexpr double g_per_mm3 = 1e-3;
  return g_per_mm3 * pi * n0_per_m3_mm / math::pow(lambda_per_mm, 4);
}

double SizeDistribution::extinction_per_m(double efficiency) const {
  return extinction_above_per_m(efficiency, 0.0);
}

double SizeDistribution::extinction_above_per_m(double efficiency, double melted_mm) const {
  constexpr double m2_per_mm2 = 1e-6;
  const double all = efficiency * 1.5 * pi * n0_per_m3_mm /
                     (holroyd_g_mm_per_cm3 * math::pow(lambda_per_mm, 4)) * m2_per_mm2;
  return all * third_moment_above(lambda_per_mm * melted_mm);
}

SizeDistribution gunn_marshall(double rate_mm_h) {
  if (!(rate_mm_h >= 0.0) || !std::isfinite(rate_mm_h))
    throw std::invalid_argument(
        fmt::format("a snowfall rate is at least 0 mm/h, got {}", rate_mm_h));
  if (rate_mm_h == 0.0) return {};
  return {3800.0 * math::pow(rate_mm_h, -0.87), 2.55 * math::pow(rate_mm_h, -0.48)};
}

double flake_diameter_mm(double melted_mm) {
  return std::sqrt(melted_mm * melted_mm * melted_mm / holroyd_g_mm_per_cm3);
}

double visibility_m(double extinction_per_m) { return 3.912 / extinction_per_m; }

}  // namespace wold::snow
