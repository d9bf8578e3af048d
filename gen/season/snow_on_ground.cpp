#include "season/snow_on_ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "season/ramp.h"

namespace wold::season {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double seconds_per_hour = 3600.0;
constexpr double melting_j_kg = 334e3;
constexpr double water_heat_j_kg_k = 4186.0;
constexpr double gravity_m_s2 = 9.81;
constexpr double densest_kg_m3 = 600.0;
constexpr double coldest_hour = 6.0, warmest_hour = 15.0, noon = 12.0, day_h = 24.0;
constexpr int steps_per_day = 8;
constexpr double step_h = day_h / steps_per_day;

/// From `from` at share 0 to `to` at 1, level at both.
double swung(double from, double to, double share) {
  return from + (to - from) * 0.5 * (1.0 - std::cos(pi * share));
}

/// A day from six to six.
struct Weather24 {
  double tmin_c, tmax_c, next_tmin_c;
  double precipitation_mm;
  double day_length_h;
  double mean_sun_w_m2;
  double clearness;

  double phase_c() const { return 0.5 * (tmax_c + next_tmin_c); }

  double temperature_c(double hour) const {
    if (hour < warmest_hour)
      return swung(tmin_c, tmax_c, (hour - coldest_hour) / (warmest_hour - coldest_hour));
    return swung(tmax_c, next_tmin_c,
                 (hour - warmest_hour) / (day_h + coldest_hour - warmest_hour));
  }

  /// The day's sun as half a wave between sunrise and sunset.
  double sun_w_m2(double hour) const {
    const double from_noon = std::min(std::abs(hour - noon), std::abs(hour - noon - day_h));
    if (from_noon >= 0.5 * day_length_h) return 0.0;
    return mean_sun_w_m2 * 0.5 * pi * day_h / day_length_h *
           std::cos(pi * from_noon / day_length_h);
  }
};

Weather24 weather_of(const Day& day, const Day& next) {
  constexpr double hargreaves_per_sqrt_k = 0.16;  // inland
  constexpr double clear_share = 0.75;            // of the sun's radiation comes through
  constexpr double w_m2_per_mj_m2 = 1e6 / (day_h * seconds_per_hour);
  const double transmitted =
      std::min(clear_share, hargreaves_per_sqrt_k * std::sqrt(day.tmax_c - day.tmin_c));
  return {.tmin_c = day.tmin_c,
          .tmax_c = day.tmax_c,
          .next_tmin_c = next.tmin_c,
          .precipitation_mm = day.precipitation_mm,
          .day_length_h = day.day_length_h,
          .mean_sun_w_m2 = transmitted * w_m2_per_mj_m2 * day.top_sun_mj_m2,
          .clearness = transmitted / clear_share};
}

void advance_day(SnowLayer& layer, const Weather24& weather, const SnowParameters& snow) {
  const double half_span = 0.5 * snow.snow_span_c;
  const double rain_share =
      ramp(weather.phase_c(), snow.half_snow_c - half_span, snow.half_snow_c + half_span);
  const double step_mm = weather.precipitation_mm / steps_per_day;
  for (int step = 0; step < steps_per_day; ++step) {
    const double hour = coldest_hour + (step + 0.5) * step_h;
    layer.advance({.temperature_c = weather.temperature_c(hour),
                   .snow_mm = step_mm * (1.0 - rain_share),
                   .rain_mm = step_mm * rain_share,
                   .sun_w_m2 = weather.sun_w_m2(hour),
                   .clearness = weather.clearness},
                  step_h);
  }
}

}  // namespace

double SnowLayer::advance(const Air& air, double hours) {
  const double before_mm = water_mm();
  take_snow(air);
  age_surface(air, hours);
  if (ice_mm_ > 0.0) {
    const double heat_mm = warmed_by_mm(air, hours);
    liquid_mm_ += air.rain_mm + melted(std::max(heat_mm, 0.0));
    chill(parameters_.chilled_share * std::max(-heat_mm, 0.0));
    drain();
    settle(air, hours);
  }
  return before_mm + air.snow_mm + air.rain_mm - water_mm();
}

/// Pahaut 1976, as in Crocus, without wind.
void SnowLayer::take_snow(const Air& air) {
  const double fresh_kg_m3 = std::max(50.0, 109.0 + 6.0 * std::min(air.temperature_c, 0.0));
  ice_mm_ += air.snow_mm;
  depth_m_ += air.snow_mm / fresh_kg_m3;
}

/// a' = -(a - old) / ageing + (fresh - a) snowfall / renewing (Essery 2015).
void SnowLayer::age_surface(const Air& air, double hours) {
  const SnowParameters& p = parameters_;
  const double age_per_h = 1.0 / (air.temperature_c > 0.0 ? p.ageing_melting_h : p.ageing_cold_h);
  const double renewed_per_h = air.snow_mm / hours / p.renewing_mm;
  const double per_h = age_per_h + renewed_per_h;
  const double tends_to = (p.albedo_old * age_per_h + p.albedo_fresh * renewed_per_h) / per_h;
  albedo_ =
      ice_mm_ > 0.0 ? tends_to + (albedo_ - tends_to) * std::exp(-per_h * hours) : p.albedo_fresh;
}

/// Heat that the pack gains, as the ice that it could melt; negative when it loses heat.
double SnowLayer::warmed_by_mm(const Air& air, double hours) const {
  const double gain_w_m2 = (1.0 - albedo_) * air.sun_w_m2 -
                           parameters_.longwave_loss_w_m2 * air.clearness +
                           parameters_.exchange_w_m2_k * air.temperature_c;
  const double rain_j_m2 = air.rain_mm * water_heat_j_kg_k * std::max(air.temperature_c, 0.0);
  return (gain_w_m2 * hours * seconds_per_hour + rain_j_m2) / melting_j_kg;
}

/// Warms the pack, then melts it from above, depth and ice alike. Returns the melt.
double SnowLayer::melted(double heat_mm) {
  const double warming_mm = std::min(heat_mm, lacking_mm_);
  lacking_mm_ -= warming_mm;
  const double melt_mm = std::min(ice_mm_, heat_mm - warming_mm);
  depth_m_ *= 1.0 - melt_mm / ice_mm_;
  ice_mm_ -= melt_mm;
  return melt_mm;
}

/// Freezes held water, then cools the ice.
void SnowLayer::chill(double loss_mm) {
  const double frozen_mm = std::min(loss_mm, liquid_mm_);
  liquid_mm_ -= frozen_mm;
  ice_mm_ += frozen_mm;
  lacking_mm_ = std::min(lacking_mm_ + loss_mm - frozen_mm, parameters_.coldest_share * ice_mm_);
}

/// Lets go what the ice cannot hold.
void SnowLayer::drain() {
  liquid_mm_ = std::min(liquid_mm_, parameters_.held_water * ice_mm_);
  if (ice_mm_ < 1e-6) vanish();
}

/// Anderson 1976: creep under the weight above the middle, and crystals that round off.
void SnowLayer::settle(const Air& air, double hours) {
  if (!(ice_mm_ > 0.0)) return;
  const bool wet = liquid_mm_ > 0.0;
  const double below_zero_k =
      wet ? 0.0 : std::min(air.temperature_c, 0.0) * std::exp(-water_mm() / 100.0);
  const double viscosity = parameters_.viscosity_pa_s / (wet ? parameters_.wet_softening : 1.0) *
                           std::exp(-below_zero_k / 12.4 + density_kg_m3() / 55.6);
  const double creep_per_s = 0.5 * gravity_m_s2 * water_mm() / viscosity;
  const double rounding_per_s =
      2.8e-6 * (wet ? 2.0 : 1.0) *
      std::exp(below_zero_k / 23.8 - std::max(density_kg_m3() - 150.0, 0.0) / 21.7);
  depth_m_ *= std::exp(-(creep_per_s + rounding_per_s) * hours * seconds_per_hour);
  depth_m_ = std::max(depth_m_, water_mm() / densest_kg_m3);
}

void SnowLayer::vanish() { ice_mm_ = liquid_mm_ = depth_m_ = lacking_mm_ = 0.0; }

std::vector<SnowOnGround> snow_on_ground(std::span<const Day> days, const SnowParameters& snow) {
  std::vector<SnowOnGround> mornings;
  SnowLayer layer(snow);
  for (std::size_t i = 0; i < days.size(); ++i) {
    mornings.push_back({layer.depth_m(), layer.water_mm()});
    const Day& next = days[std::min(i + 1, days.size() - 1)];
    advance_day(layer, weather_of(days[i], next), snow);
  }
  return mornings;
}

}  // namespace wold::season
