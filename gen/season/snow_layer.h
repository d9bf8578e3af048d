#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace wold::season {

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
  double chilled_share = 0.0927;      ///< of the surface's loss of heat that the pack feels

  double snow_span_c = 2.0;         ///< from all snow to all rain
  double exchange_w_m2_k = 6.0;     ///< of heat with the air, per degree
  double wet_softening = 5.0;       ///< viscosity of dry snow over that of wet
  double held_water = 0.05;         ///< share of the ice's mass (Essery 2015)
  double coldest_share = 0.03;      ///< heat that the ice can lack, over its heat of melting
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
struct SnowAir {
  double temperature_c = 0.0;
  double snow_mm = 0.0;  ///< falls
  double rain_mm = 0.0;
  double sun_w_m2 = 0.0;       ///< on the level
  double clearness = 1.0;      ///< 0 overcast to 1
  double diffuse_w_m2 = 0.0;   ///< of the sun's: the sky's light, which slopes get as well
  glm::dvec2 slant_w_m2{0.0};  ///< direct light's horizontal part, as it comes from east and north
};

/// What a step of such air does to all snow at one height.
struct SnowStep {
  double snow_mm = 0.0;
  double rain_mm = 0.0;
  double fresh_m_per_mm = 0.01;
  double ageing = 0.0;  ///< time constants of ageing that pass
  double unaged = 1.0;  ///< exp(-ageing)
  /// Heat, as the ice that it could melt.
  double sun_mm = 0.0, diffuse_mm = 0.0, other_mm = 0.0;
  glm::dvec2 slant_mm{0.0};
  double below_zero_c = 0.0;  ///< the air's temperature where it freezes, or 0
  double seconds = 0.0;
};

/// At which no rain falls, by the usual parameters.
inline constexpr double all_snow_c =
    SnowParameters{}.half_snow_c - 0.5 * SnowParameters{}.snow_span_c;

/// Fresh snow of so much water at 0 degrees.
SnowState fresh_snow(double water_mm);

/// Share of precipitation that is snow: half at half_snow_c, linear within snow_span_c about it.
double snow_share(double temperature_c, const SnowParameters& parameters = {});

SnowStep snow_step(const SnowAir& air, double hours, const SnowParameters& parameters = {});

/// The sun's heat on ground that rises so much per metre to the east and to the north: direct light
/// by the angle at which it comes, none where the ground is turned from it; the sky's as on the
/// level. Per horizontal area.
inline double sun_mm(const SnowStep& step, const glm::dvec2& rise) {
  return std::max(step.sun_mm - glm::dot(rise, step.slant_mm), step.diffuse_mm);
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
  constexpr double least_ice_mm = 1e-6, densest_kg_m3 = 600.0, gravity_m_s2 = 9.81;
  const double fallen_mm = step.snow_mm * drift;
  double ice_mm = snow.water_mm - snow.liquid_mm + fallen_mm;
  if (!(ice_mm > least_ice_mm)) {
    const double out_mm = snow.water_mm + fallen_mm + step.rain_mm;
    snow = {};
    return out_mm;
  }
  double depth_m = snow.depth_m + fallen_mm * step.fresh_m_per_mm;

  // a' = -(a - old) / ageing + (fresh - a) snowfall / renewing
  const double renewed = fallen_mm / p.renewing_mm;
  const double tends_to = step.ageing / (step.ageing + renewed);
  const double unaged = renewed > 0.0 ? std::exp(-step.ageing - renewed) : step.unaged;
  snow.age = tends_to + (snow.age - tends_to) * unaged;

  const double albedo = p.albedo_fresh + (p.albedo_old - p.albedo_fresh) * snow.age;
  const double heat_mm = (1.0 - albedo) * sun_mm + step.other_mm;
  const double warming_mm = std::clamp(heat_mm, 0.0, snow.lacking_mm);
  const double melt_mm = std::min(std::max(heat_mm, 0.0) - warming_mm, ice_mm);
  depth_m *= 1.0 - melt_mm / ice_mm;
  ice_mm -= melt_mm;
  const double wet_mm = snow.liquid_mm + step.rain_mm + melt_mm;
  const double loss_mm = p.chilled_share * std::max(-heat_mm, 0.0);
  const double frozen_mm = std::min(loss_mm, wet_mm);
  ice_mm += frozen_mm;
  const double lacking_mm = snow.lacking_mm - warming_mm + loss_mm - frozen_mm;
  if (!(ice_mm > least_ice_mm)) {
    snow = {};
    return ice_mm + wet_mm - frozen_mm;
  }
  const double liquid_mm = std::min(wet_mm - frozen_mm, p.held_water * ice_mm);
  const double out_mm = wet_mm - frozen_mm - liquid_mm;
  snow.lacking_mm = std::min(lacking_mm, p.coldest_share * ice_mm);
  snow.liquid_mm = liquid_mm;
  snow.water_mm = ice_mm + liquid_mm;

  const bool wet = liquid_mm > 0.0;
  const double density_kg_m3 = snow.water_mm / depth_m;
  const double below_zero_c =
      wet || step.below_zero_c == 0.0 ? 0.0 : step.below_zero_c * std::exp(-snow.water_mm / 100.0);
  const double fluidity = (wet ? p.wet_softening : 1.0) / p.viscosity_pa_s *
                          std::exp(below_zero_c / 12.4 - density_kg_m3 / 55.6);
  const double creep_per_s = 0.5 * gravity_m_s2 * snow.water_mm * fluidity;
  const double rounding_per_s =
      (wet ? 5.6e-6 : 2.8e-6) *
      std::exp(below_zero_c / 23.8 - std::max(density_kg_m3 - 150.0, 0.0) / 21.7);
  depth_m *= std::exp(-(creep_per_s + rounding_per_s) * step.seconds);
  snow.depth_m = std::max(depth_m, snow.water_mm / densest_kg_m3);
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

  using Air = SnowAir;
  /// Returns the water that leaves the pack, mm: snow and rain = more water + what left.
  double advance(const Air& air, double hours) {
    const SnowStep step = snow_step(air, hours, parameters_);
    return season::advance(snow_, step, 1.0, step.sun_mm, parameters_);
  }

 private:
  const SnowParameters& parameters_;
  SnowState snow_;
};

}  // namespace wold::season
