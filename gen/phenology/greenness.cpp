#include "phenology/greenness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "phenology/ramp.h"

namespace wold::phenology {
namespace {

constexpr std::size_t days_per_year = 365;
/// Where nothing grows in a year, the little that does must not count as a lush meadow.
constexpr double min_greenest = 0.2;

double mean_c(const weather::Day& day) { return 0.5 * (day.tmin_c + day.tmax_c); }

/// What plants remember of the weather, and what they have grown.
class Meadow {
 public:
  Meadow(const MeadowParameters& parameters, const weather::Day& first)
      : parameters_(parameters), warmth_c_(mean_c(first)) {
    water_.soil_mm = 0.5 * parameters.capacity_mm;
  }

  double advance(const weather::Day& day) {
    warmth_c_ += (mean_c(day) - warmth_c_) / parameters_.warmth_days;
    water_.advance(day, potential_evaporation_mm(day), green_, parameters_);
    moisture_ += (water_.soil_mm / parameters_.capacity_mm - moisture_) / parameters_.rooting_days;
    grow_towards(allowed_by(day.day_length_h));
    return green_;
  }

 private:
  double allowed_by(double day_length) const {
    const MeadowParameters& p = parameters_;
    const double warmth = ramp(warmth_c_, p.cold_c, p.mild_c) *
                          (1.0 - ramp(warmth_c_, p.hot_c, p.hot_c + p.deadly_heat_span_c));
    const double light = ramp(day_length, p.short_day_h, p.long_day_h);
    return std::min(warmth, light) * ramp(moisture_, p.dry, p.moist);
  }

  void grow_towards(double allowed) {
    const double seeded = parameters_.seed + (1.0 - parameters_.seed) * green_;
    const double rate =
        allowed > green_ ? parameters_.growth_per_day * seeded : parameters_.decay_per_day;
    green_ += rate * (allowed - green_);
  }

  const MeadowParameters& parameters_;
  SoilWater water_;
  double warmth_c_;
  double moisture_ = 0.5;  ///< of the soil, as the roots have felt it lately
  double green_ = 0.05;
};

}  // namespace

double potential_evaporation_mm(const weather::Day& day) {
  constexpr double mm_per_mj_m2 = 1.0 / 2.45;  // evaporated by it, of water
  const double radiation_mm = mm_per_mj_m2 * day.top_sun_mj_m2;
  return std::max(
      0.0, 0.0023 * radiation_mm * (mean_c(day) + 17.8) * std::sqrt(day.tmax_c - day.tmin_c));
}

SoilWater::Loss SoilWater::advance(const weather::Day& day, double potential_mm, double green,
                                   const MeadowParameters& meadow) {
  constexpr double snows_below_c = 1.0;
  constexpr double melt_mm_per_degree_day = 3.0;
  const double snowfall_mm = mean_c(day) < snows_below_c ? day.precipitation_mm : 0.0;
  snow_mm += snowfall_mm;
  const double melt_mm = std::min(snow_mm, melt_mm_per_degree_day * std::max(mean_c(day), 0.0));
  snow_mm -= melt_mm;
  const double cover = meadow.bare_evaporation + (1.0 - meadow.bare_evaporation) * green;
  const double at_hand = std::min(1.0, 2.0 * soil_mm / meadow.capacity_mm);
  soil_mm += day.precipitation_mm - snowfall_mm + melt_mm;
  const double evaporated_mm = std::min(soil_mm, potential_mm * cover * at_hand);
  soil_mm -= evaporated_mm;
  const double drained_mm = std::max(0.0, soil_mm - meadow.capacity_mm);
  soil_mm -= drained_mm;
  return {evaporated_mm, drained_mm};
}

std::vector<double> greenness(std::span<const weather::Day> days,
                              const MeadowParameters& parameters) {
  if (days.empty()) return {};
  Meadow meadow(parameters, days.front());
  for (const weather::Day& day : days.first(std::min(days.size(), days_per_year)))
    meadow.advance(day);
  std::vector<double> green;
  for (const weather::Day& day : days) green.push_back(meadow.advance(day));
  if (days.size() < days_per_year) return green;
  const double greenest = std::max(min_greenest, *std::max_element(green.begin(), green.end()));
  for (double& value : green) value /= greenest;
  return green;
}

}  // namespace wold::phenology
