#include "snow/flake_sizes.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "snow/near_field.h"
#include "snow/raindrops.h"
#include "snow/size_distribution.h"

namespace wold::snow {
namespace {

/// Mean speed of flakes of a size.
double mean_speed_m_s(scene::CrystalChoice choice, double diameter_mm) {
  const auto fractions = crystal_fractions(choice, diameter_mm);
  double mean = 0.0;
  for (std::size_t i = 0; i < crystal_kinds; ++i)
    mean += fractions[i] * fall_speed_m_s(static_cast<Crystal>(i), diameter_mm);
  return mean;
}

/// Mean speed of the water in the air, flakes of all sizes: that of x^3 exp(-x) / 6, x = Lambda d.
double speed_of_water_m_s(scene::CrystalChoice choice, double lambda_per_mm) {
  constexpr int steps = 600;
  constexpr double highest = 30.0, step = highest / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) * step;
    sum += step * x * x * x * math::exp(-x) / 6.0 *
           mean_speed_m_s(choice, flake_diameter_mm(x / lambda_per_mm));
  }
  return sum;
}

/// e of a rank among so many: evenly spread in what lies below.
double deviate_of(std::size_t rank, std::size_t ranks) {
  return -math::log1p(-(static_cast<double>(rank) + 0.5) / static_cast<double>(ranks));
}

}  // namespace

void FlakeSizes::set_speed(std::size_t rank, double speed_m_s) {
  constexpr double rank_unit_m_s = static_cast<double>(speed_unit_m_s) * (1 << finer_bits);
  speeds_[rank] = static_cast<std::uint16_t>(std::lround(speed_m_s / rank_unit_m_s));
}

FlakeSizes::FlakeSizes(double rate_mm_h, scene::CrystalChoice crystal) : FlakeSizes() {
  const SizeDistribution sizes = gunn_marshall(rate_mm_h);
  constexpr double g_per_m2_s_of_mm_h = 1000.0 / 3600.0;
  const double factor = g_per_m2_s_of_mm_h * rate_mm_h / sizes.water_g_per_m3() /
                        speed_of_water_m_s(crystal, sizes.lambda_per_mm);
  std::array<double, crystal_kinds> owed = {};
  for (std::size_t rank = 0; rank < speeds_.size(); ++rank) {
    const double deviate = deviate_of(rank, speeds_.size());
    const double diameter_mm = flake_diameter_mm(min_melted_mm + deviate / sizes.lambda_per_mm);
    const auto fractions = crystal_fractions(crystal, diameter_mm);
    for (std::size_t i = 0; i < crystal_kinds; ++i) owed[i] += fractions[i];
    const auto max = std::max_element(owed.begin(), owed.end());
    *max -= 1.0;
    crystals_[rank] = static_cast<Crystal>(max - owed.begin());
    set_speed(rank, factor * fall_speed_m_s(crystals_[rank], diameter_mm));
    deviates_[rank] = static_cast<float>(deviate);
  }
}

FlakeSizes FlakeSizes::raindrops(double heaviest_mm_h) {
  FlakeSizes drops;
  drops.heaviest_mm_h_ = heaviest_mm_h;
  drops.slowest_ = static_cast<std::uint64_t>(one_);
  drops.step_ = 0;
  const double lambda_per_mm = marshall_palmer(heaviest_mm_h).lambda_per_mm;
  for (std::size_t rank = 0; rank < drops.speeds_.size(); ++rank) {
    const double deviate = deviate_of(rank, drops.speeds_.size());
    drops.set_speed(rank, drop_speed_m_s(min_drop_mm + deviate / lambda_per_mm));
    drops.deviates_[rank] = static_cast<float>(deviate);
  }
  return drops;
}

std::vector<float> FlakeSizes::diameters_m(double rate_mm_h) const {
  constexpr double m_per_mm = 1e-3;
  const bool rain = heaviest_mm_h_ > 0.0;
  const double lambda_per_mm =
      rain ? marshall_palmer(heaviest_mm_h_).lambda_per_mm : gunn_marshall(rate_mm_h).lambda_per_mm;
  std::vector<float> diameters(deviates_.size());
  for (std::size_t rank = 0; rank < deviates_.size(); ++rank) {
    const double above_mm = static_cast<double>(deviates_[rank]) / lambda_per_mm;
    diameters[rank] = static_cast<float>(
        m_per_mm * (rain ? min_drop_mm + above_mm : flake_diameter_mm(min_melted_mm + above_mm)));
  }
  return diameters;
}

double FlakeSizes::thinning_per_m(double rate_mm_h) const {
  if (heaviest_mm_h_ <= 0.0) return 0.0;
  constexpr double mm_per_m = 1000.0;
  return mm_per_m *
         (marshall_palmer(rate_mm_h).lambda_per_mm - marshall_palmer(heaviest_mm_h_).lambda_per_mm);
}

}  // namespace wold::snow
