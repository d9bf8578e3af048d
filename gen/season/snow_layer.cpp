#include "season/snow_layer.h"

#include "season/ramp.h"

namespace wold::season {
namespace {

/// Pahaut 1976, as in Crocus, without wind.
double fresh_kg_m3(double temperature_c) {
  return std::max(50.0, 109.0 + 6.0 * std::min(temperature_c, 0.0));
}

}  // namespace

SnowState fresh_snow(double water_mm) {
  return {.water_mm = water_mm, .depth_m = water_mm / fresh_kg_m3(0.0)};
}

double snow_share(double temperature_c, const SnowParameters& parameters) {
  const double half_span_c = 0.5 * parameters.snow_span_c;
  return 1.0 - ramp(temperature_c, parameters.half_snow_c - half_span_c,
                    parameters.half_snow_c + half_span_c);
}

SnowStep snow_step(const SnowAir& air, double hours, const SnowParameters& parameters) {
  constexpr double seconds_per_hour = 3600.0, melting_j_kg = 334e3, water_heat_j_kg_k = 4186.0;
  const double seconds = seconds_per_hour * hours;
  const double mm_per_w_m2 = seconds / melting_j_kg;
  const double ageing =
      hours / (air.temperature_c > 0.0 ? parameters.ageing_melting_h : parameters.ageing_cold_h);
  const double other_w_m2 = parameters.exchange_w_m2_k * air.temperature_c -
                            parameters.longwave_loss_w_m2 * air.clearness;
  const double rain_mm =
      air.rain_mm * water_heat_j_kg_k * std::max(air.temperature_c, 0.0) / melting_j_kg;
  return {.snow_mm = air.snow_mm,
          .rain_mm = air.rain_mm,
          .fresh_m_per_mm = 1.0 / fresh_kg_m3(air.temperature_c),
          .ageing = ageing,
          .unaged = std::exp(-ageing),
          .sun_mm = mm_per_w_m2 * air.sun_w_m2,
          .diffuse_mm = mm_per_w_m2 * air.diffuse_w_m2,
          .other_mm = mm_per_w_m2 * other_w_m2 + rain_mm,
          .slant_mm = mm_per_w_m2 * air.slant_w_m2,
          .below_zero_c = std::min(air.temperature_c, 0.0),
          .seconds = seconds};
}

}  // namespace wold::season
