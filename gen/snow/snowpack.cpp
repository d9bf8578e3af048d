#include "snow/snowpack.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace wold::snow {
namespace {

constexpr double hours_per_day = 24.0;
/// Settling and ageing by time constants: Essery 2015, A factorial snowpack model (FSM 1.0).
constexpr double settling_h = 200.0;
constexpr double settled_cold_kg_m3 = 300.0, settled_melting_kg_m3 = 500.0;
constexpr double ageing_cold_h = 1000.0, ageing_melting_h = 100.0;
constexpr double renewing_mm = 10.0;  ///< snowfall that takes a surface 1 - 1/e of the way to fresh

/// Ages as FSM's albedo does: a' = -(a - min) / ageing_h + (max - a) snowfall / renewing_mm.
void set_ageing(PackStep& step, double ageing_h, double hours) {
  const double age_per_h = 1.0 / ageing_h;
  const double renewed_per_h = hours > 0.0 ? step.snow_mm / hours / renewing_mm : 0.0;
  step.aged = age_per_h / (age_per_h + renewed_per_h);
  step.unaged = math::exp(-(age_per_h + renewed_per_h) * hours);
}

/// Fresh snow has settled for half the step, which is the mean over what fell in it.
double fresh_depth_m_per_mm(double fresh_kg_m3, double settled_kg_m3, double hours) {
  return 1.0 /
         (settled_kg_m3 + (fresh_kg_m3 - settled_kg_m3) * math::exp(-0.5 * hours / settling_h));
}

}  // namespace

double fresh_density_kg_m3(double temperature_c) {
  return std::min(120.0, 67.92 + 51.25 * math::exp(temperature_c / 2.59));
}

PackStep pack_step(const WeatherMoment& weather, double height_m, double hours,
                   double melt_mm_per_day) {
  const double temperature_c = weather.temperature_c - lapse_k_per_m * height_m;
  const bool melts = temperature_c > 0.0;
  PackStep step;
  step.snow_mm = weather.precipitation_mm_h * snow_fraction(temperature_c) * hours;
  step.melt_mm = melt_mm_per_day / hours_per_day * std::max(temperature_c, 0.0) * hours;
  step.settled_kg_m3 = melts ? settled_melting_kg_m3 : settled_cold_kg_m3;
  step.unsettled = math::exp(-hours / settling_h);
  step.fresh_m_per_mm =
      fresh_depth_m_per_mm(fresh_density_kg_m3(temperature_c), step.settled_kg_m3, hours);
  set_ageing(step, melts ? ageing_melting_h : ageing_cold_h, hours);
  return step;
}

}  // namespace wold::snow
