#pragma once

#include "snow/weather.h"

namespace wold::snow {

/// The snow that lies at one place, per horizontal area.
struct Snowpack {
  double water_mm = 0.0;  ///< kg/m2
  double depth_m = 0.0;   ///< vertical
  double age = 0.0;       ///< of its surface: 0 fresh, tends to 1 without snowfall
};

/// What a step of weather does to every pack at one height. Rates are those of the step's middle
/// and hold for all of it.
struct PackStep {
  double snow_mm = 0.0;          ///< falls, as water
  double melt_mm = 0.0;          ///< melts at most
  double settled_kg_m3 = 300.0;  ///< density that packs tend to
  double unsettled = 1.0;        ///< fraction of the way to it that remains
  double fresh_m_per_mm = 0.01;  ///< depth of what fell, at the step's end
  double aged = 1.0;             ///< age that surfaces tend to
  double unaged = 1.0;           ///< fraction of the way to it that remains
};

/// Density of fresh snow, kg/m3: 67.92 + 51.25 exp(T / 2.59), at most 120 (Hedstrom and Pomeroy
/// 1998, Measurements and modelling of snow interception in the boreal forest).
double fresh_density_kg_m3(double temperature_c);

/// A step of `hours` >= 0 under `weather`, at a height above the terrain's zero; melt_mm_per_day is
/// the degree-day factor.
PackStep pack_step(const WeatherMoment& weather, double height_m, double hours,
                   double melt_mm_per_day);

/// The pack after the step, with `drift` times as much snowfall as in the open. What melts leaves
/// at once, with its fraction of the depth, and rain runs through: fallen water = more lying water
/// + melted water.
inline Snowpack advanced(const Snowpack& pack, const PackStep& step, double drift = 1.0) {
  const double fallen_mm = step.snow_mm * drift;
  const double whole_mm = pack.water_mm + fallen_mm;
  const double water_mm = whole_mm - step.melt_mm;
  if (!(water_mm > 0.0)) return {};
  double depth_m = fallen_mm * step.fresh_m_per_mm;
  if (pack.depth_m > 0.0) {
    // density -> settled + (density - settled) unsettled, unless it is higher already
    const double settled_mm = step.settled_kg_m3 * pack.depth_m;
    depth_m += pack.water_mm >= settled_mm
                   ? pack.depth_m
                   : pack.depth_m * pack.water_mm /
                         (settled_mm + (pack.water_mm - settled_mm) * step.unsettled);
  }
  if (step.melt_mm > 0.0) depth_m *= water_mm / whole_mm;
  const double age = pack.water_mm > 0.0 ? pack.age : 0.0;
  return {water_mm, depth_m, step.aged + (age - step.aged) * step.unaged};
}

/// Reflectance of a surface in all sunlight, 0.85 to 0.5 (Essery 2015, A factorial snowpack model,
/// whose rates the age follows).
inline double broadband_albedo(double age) { return 0.85 - 0.35 * age; }

/// Reflectance in visible light, which is what pictures show: 0.95 (1 - 0.2 age), 0.95 to 0.76
/// (Dickinson and others 1993, Biosphere-Atmosphere Transfer Scheme). Old snow darkens mostly in
/// the infrared: the broadband value would make it grey.
inline double visible_albedo(double age) { return 0.95 * (1.0 - 0.2 * age); }

}  // namespace wold::snow
