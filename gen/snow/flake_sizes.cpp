#include "snow/flake_sizes.h"

#include <algorithm>
#include <cmath>

#include "snow/near_field.h"
#include "snow/size_distribution.h"

namespace wold::snow {
namespace {

/// Mean speed of flakes of a size.
double mean_speed_m_s(const std::string& choice, double diameter_mm) {
  const auto shares = crystal_shares(choice, diameter_mm);
  double mean = 0.0;
  for (std::size_t i = 0; i < crystal_kinds; ++i)
    mean += shares[i] * fall_speed_m_s(static_cast<Crystal>(i), diameter_mm);
  return mean;
}

/// Mean speed of the water in the air, flakes of all sizes: that of x^3 exp(-x) / 6, x = Lambda d.
double speed_of_water_m_s(const std::string& choice, double lambda_per_mm) {
  constexpr int steps = 600;
  constexpr double highest = 30.0, step = highest / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) * step;
    sum += step * x * x * x * std::exp(-x) / 6.0 *
           mean_speed_m_s(choice, flake_diameter_mm(x / lambda_per_mm));
  }
  return sum;
}

}  // namespace

FlakeSizes::FlakeSizes(double rate_mm_h, const std::string& crystal)
    : speeds_(1U << rank_bits), crystals_(speeds_.size()), deviates_(speeds_.size()) {
  const SizeDistribution sizes = gunn_marshall(rate_mm_h);
  constexpr double rank_unit_m_s = static_cast<double>(speed_unit_m_s) * (1 << finer_bits);
  constexpr double g_per_m2_s_of_mm_h = 1000.0 / 3600.0;
  const double factor = g_per_m2_s_of_mm_h * rate_mm_h / sizes.water_g_per_m3() /
                        speed_of_water_m_s(crystal, sizes.lambda_per_mm);
  std::array<double, crystal_kinds> owed = {};
  for (std::size_t rank = 0; rank < speeds_.size(); ++rank) {
    const double u = (static_cast<double>(rank) + 0.5) / static_cast<double>(speeds_.size());
    const double deviate = -std::log1p(-u);
    const double diameter_mm = flake_diameter_mm(least_melted_mm + deviate / sizes.lambda_per_mm);
    const auto shares = crystal_shares(crystal, diameter_mm);
    for (std::size_t i = 0; i < crystal_kinds; ++i) owed[i] += shares[i];
    const auto most = std::max_element(owed.begin(), owed.end());
    *most -= 1.0;
    crystals_[rank] = static_cast<Crystal>(most - owed.begin());
    const double speed_m_s = factor * fall_speed_m_s(crystals_[rank], diameter_mm);
    speeds_[rank] = static_cast<std::uint16_t>(std::lround(speed_m_s / rank_unit_m_s));
    deviates_[rank] = static_cast<float>(deviate);
  }
}

std::vector<float> FlakeSizes::diameters_m(double lambda_per_mm) const {
  constexpr double m_per_mm = 1e-3;
  std::vector<float> diameters(deviates_.size());
  for (std::size_t rank = 0; rank < deviates_.size(); ++rank)
    diameters[rank] = static_cast<float>(
        m_per_mm *
        flake_diameter_mm(least_melted_mm + static_cast<double>(deviates_[rank]) / lambda_per_mm));
  return diameters;
}

}  // namespace wold::snow
