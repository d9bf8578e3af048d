#pragma once

#include "core/elementary.h"
#include "snowpack/decay.h"

namespace wold::snowpack {

/// How snow falls, settles and melts: one set for all places.
///
/// The first four were fitted to the snow that was measured at Col de Porte in the winters that
/// begin in odd years from 1993 to 2003 (tests/benchmark/fit_season.cpp; Lejeune and others 2019,
/// Earth System Science Data 11:71); the others are of the literature where it is named, or rounded
/// from trials with all of these winters.
struct SnowParameters {
  double half_snow_c = -0.143;     ///< at which as much falls as snow as as rain
  double viscosity_pa_s = 4.61e7;  ///< of snow without density at 0 degrees (Anderson 1976: 3.7e7)
  double longwave_loss_w_m2 = 121.0;  ///< of snow under a clear sky, net
  double chilled_fraction = 0.0927;   ///< of the surface's loss of heat that the pack feels

  double snow_span_c = 2.0;         ///< from all snow to all rain
  double exchange_w_m2_k = 6.0;     ///< of heat with the air, per degree
  double wet_softening = 5.0;       ///< viscosity of dry snow over that of wet
  double held_water = 0.05;         ///< fraction of the ice's mass (Essery 2015)
  double coldest_fraction = 0.03;   ///< heat that the ice can lack, over its heat of melting
  double albedo_fresh = 0.85;       ///< Essery 2015, A factorial snowpack model
  double albedo_old = 0.5;          ///< the same
  double ageing_cold_h = 1000.0;    ///< the same
  double ageing_melting_h = 300.0;  ///< 100 there
  double renewing_mm = 10.0;        ///< snowfall that makes a surface fresh, the same
};

/// The snow that lies at one place: a single layer of ice and held water, per horizontal area.
struct SnowState {
  double water_mm = 0.0;  ///< ice and liquid, kg/m2
  double depth_m = 0.0;   ///< vertical
  double age = 0.0;       ///< of its surface: 0 fresh, tends to 1 without snowfall
  double liquid_mm = 0.0;
  double lacking_mm = 0.0;  ///< melt that the heat would make which the pack needs to be at 0
};

/// What the air does for some hours.
struct SnowForcing {
  double temperature_c = 0.0;
  double snow_mm = 0.0;  ///< falls
  double rain_mm = 0.0;
  double sun_w_m2 = 0.0;          ///< on the level
  double clearness = 1.0;         ///< 0 overcast to 1
  double diffuse_w_m2 = 0.0;      ///< of the sun's: the sky's light, which slopes get as well
  double slant_east_w_m2 = 0.0;   ///< direct light's horizontal part, as it comes from the east
  double slant_north_w_m2 = 0.0;  ///< and the north
};

/// What a step of such air does to all snow there. Heat is the ice that it could melt.
struct SnowStep {
  double snow_mm = 0.0;
  double rain_mm = 0.0;
  double fresh_m_per_mm = 0.01;
  double ageing = 0.0;  ///< time constants of ageing that pass
  double sun_mm = 0.0;
  double diffuse_mm = 0.0;
  double slant_east_mm = 0.0, slant_north_mm = 0.0;
  double other_mm = 0.0;      ///< by the air, rain and longwave radiation
  double below_zero_k = 0.0;  ///< of the air
  double seconds = 0.0;
};

/// At which no rain falls, by the usual parameters.
inline constexpr double all_snow_c =
    SnowParameters{}.half_snow_c - 0.5 * SnowParameters{}.snow_span_c;

/// Fraction of a day's precipitation that is snow, by a temperature of the day: half at
/// half_snow_c, linear within snow_span_c about it. snow::snow_fraction() is the rule for the
/// temperature of an hour.
inline double snow_fraction(double temperature_c, const SnowParameters& parameters = {}) {
  const double fraction =
      0.5 - (temperature_c - parameters.half_snow_c) * (1.0 / parameters.snow_span_c);
  return greater(lesser(fraction, 1.0), 0.0);
}

/// Density of fresh snow: Pahaut 1976, as in Crocus, without wind.
inline double fresh_kg_m3(double temperature_c) {
  return greater(50.0, 109.0 + 6.0 * lesser(temperature_c, 0.0));
}

inline SnowStep snow_step(const SnowForcing& air, double hours,
                          const SnowParameters& parameters = {}) {
  constexpr double seconds_per_hour = 3600.0, melting_j_kg = 334e3, water_heat_j_kg_k = 4186.0;
  const double seconds = seconds_per_hour * hours;
  const double mm_per_w_m2 = seconds / melting_j_kg;
  const double ageing = air.temperature_c > 0.0 ? hours / parameters.ageing_melting_h
                                                : hours / parameters.ageing_cold_h;
  const double other_w_m2 = parameters.exchange_w_m2_k * air.temperature_c -
                            parameters.longwave_loss_w_m2 * air.clearness;
  const double by_rain_mm =
      air.rain_mm * greater(air.temperature_c, 0.0) * (water_heat_j_kg_k / melting_j_kg);
  return {.snow_mm = air.snow_mm,
          .rain_mm = air.rain_mm,
          .fresh_m_per_mm = 1.0 / fresh_kg_m3(air.temperature_c),
          .ageing = ageing,
          .sun_mm = mm_per_w_m2 * air.sun_w_m2,
          .diffuse_mm = mm_per_w_m2 * air.diffuse_w_m2,
          .slant_east_mm = mm_per_w_m2 * air.slant_east_w_m2,
          .slant_north_mm = mm_per_w_m2 * air.slant_north_w_m2,
          .other_mm = mm_per_w_m2 * other_w_m2 + by_rain_mm,
          .below_zero_k = greater(-air.temperature_c, 0.0),
          .seconds = seconds};
}

/// Snow of so much water that lies when the weather begins. Its own weight has packed it: little is
/// as it fell at 0 degrees, and much tends to the 300 kg/m3 of a winter's snow (alpine snow has 220
/// and more, [Sturm2010]). By how much water is a modelling choice.
inline SnowState lain_snow(double water_mm) {
  constexpr double packed_kg_m3 = 300.0, packing_mm = 100.0;
  const double fallen_kg_m3 = fresh_kg_m3(0.0);
  const double density_kg_m3 =
      packed_kg_m3 - (packed_kg_m3 - fallen_kg_m3) * math::exp(-water_mm / packing_mm);
  return {.water_mm = water_mm, .depth_m = water_mm / density_kg_m3};
}

/// The sun's heat on ground that rises so much per metre to the east and to the north: direct light
/// by the angle at which it comes, none where the ground is turned from it; the sky's as on the
/// level. Per horizontal area.
inline double sun_mm(const SnowStep& step, double rise_east, double rise_north) {
  return greater(step.sun_mm - rise_east * step.slant_east_mm - rise_north * step.slant_north_mm,
                 step.diffuse_mm);
}

/// Advances `snow` by a step with `drift` times the snowfall and so much heat of the sun. Returns
/// the water that leaves it, mm: snow and rain = more water + what left.
///
/// Heat comes by the sun less what the albedo reflects, from the air and rain, and goes by longwave
/// radiation; it warms the pack, then melts it from above, depth and ice alike. Snow settles by
/// Anderson's law (1976, A point energy and mass balance model of a snow cover): creep under the
/// weight above the middle, and crystals that round off. Surfaces age as Essery's (2015) albedo.
inline double advance(SnowState& snow, const SnowStep& step, double drift, double sun_mm,
                      const SnowParameters& p) {
  constexpr double min_ice_mm = 1e-6, densest_kg_m3 = 600.0, gravity_m_s2 = 9.81;
  const double fallen_mm = step.snow_mm * drift;
  const double whole_mm = snow.water_mm - snow.liquid_mm + fallen_mm;
  const bool has_ice = whole_mm > min_ice_mm;

  // a' = -(a - old) / ageing + (fresh - a) snowfall / renewing
  const double renewed = fallen_mm * (1.0 / p.renewing_mm);
  const double tends_to = step.ageing / (step.ageing + renewed);
  const double age = tends_to + (snow.age - tends_to) * decay(step.ageing + renewed);

  const double albedo = p.albedo_fresh + (p.albedo_old - p.albedo_fresh) * age;
  const double heat_mm = (1.0 - albedo) * sun_mm + step.other_mm;
  const double gain_mm = greater(heat_mm, 0.0),
               loss_mm = -p.chilled_fraction * lesser(heat_mm, 0.0);
  const double warming_mm = lesser(gain_mm, snow.lacking_mm);
  const double melt_mm = lesser(gain_mm - warming_mm, whole_mm);
  const double wet_mm = snow.liquid_mm + step.rain_mm + melt_mm;
  const double frozen_mm = lesser(loss_mm, wet_mm);
  const double ice_mm = whole_mm - melt_mm + frozen_mm;
  const double liquid_mm = lesser(wet_mm - frozen_mm, p.held_water * ice_mm);
  const double lacking_mm = snow.lacking_mm - warming_mm + loss_mm - frozen_mm;
  const double water_mm = ice_mm + liquid_mm;

  const bool stays = has_ice && ice_mm > min_ice_mm;
  const double out_mm = wet_mm - frozen_mm - liquid_mm + (stays ? 0.0 : water_mm);
  const double loose_m =
      (snow.depth_m + fallen_mm * step.fresh_m_per_mm) * (1.0 - melt_mm / whole_mm);

  const bool wet = liquid_mm > 0.0;
  const double density_kg_m3 = water_mm / loose_m;
  const double cold_k = wet ? 0.0 : step.below_zero_k * decay(water_mm * (1.0 / 100.0));
  const double fluidity = (wet ? p.wet_softening / p.viscosity_pa_s : 1.0 / p.viscosity_pa_s) *
                          decay(cold_k * (1.0 / 12.4) + density_kg_m3 * (1.0 / 55.6));
  const double creep_per_s = 0.5 * gravity_m_s2 * water_mm * fluidity;
  const double rounding_per_s =
      (wet ? 5.6e-6 : 2.8e-6) *
      decay(cold_k * (1.0 / 23.8) + greater(density_kg_m3 - 150.0, 0.0) * (1.0 / 21.7));
  const double settled_m = loose_m * decay((creep_per_s + rounding_per_s) * step.seconds);

  snow.water_mm = stays ? water_mm : 0.0;
  snow.depth_m = stays ? greater(settled_m, water_mm * (1.0 / densest_kg_m3)) : 0.0;
  snow.age = stays ? age : 0.0;
  snow.liquid_mm = stays ? liquid_mm : 0.0;
  snow.lacking_mm = stays ? lesser(lacking_mm, p.coldest_fraction * ice_mm) : 0.0;
  return out_mm;
}

/// Snow on level, open ground, and what goes in and out.
class SnowLayer {
 public:
  explicit SnowLayer(const SnowParameters& parameters, const SnowState& first = {})
      : parameters_(parameters), snow_(first) {}

  double depth_m() const { return snow_.depth_m; }
  double water_mm() const { return snow_.water_mm; }
  double density_kg_m3() const {
    return snow_.depth_m > 0.0 ? snow_.water_mm / snow_.depth_m : 0.0;
  }

  using Air = SnowForcing;
  /// Returns the water that leaves the pack, mm: snow and rain = more water + what left.
  double advance(const Air& air, double hours) {
    const SnowStep step = snow_step(air, hours, parameters_);
    return snowpack::advance(snow_, step, 1.0, step.sun_mm, parameters_);
  }

 private:
  const SnowParameters& parameters_;
  SnowState snow_;
};

}  // namespace wold::snowpack
