#pragma once

#include <functional>

#include "scene/scene.h"
#include "snow/weather.h"

namespace wold::meadow {

/// Snow that falls on a canopy and how warm it is, at one moment.
struct CanopyWeather {
  double temperature_c = 0.0;
  double snowfall_mm_h = 0.0;  ///< of water
};

/// How much snow a canopy of this leaf area index can carry, mm of water: 0.70 per unit (leaf area
/// times grass::leaf_snow_kg_m2).
double canopy_capacity_mm(double leaf_area_index);

/// Rate at which snow comes off a canopy, 1/h. In the cold it slips, sublimes and is shaken off
/// within 2.5 days (Hedstrom and Pomeroy 1998: a week's storms lose a third to a half); from 1
/// degree on it slides and drips off within 1.5 hours; between 0 and 1 degree linear.
double unloading_per_h(double temperature_c);

/// Fraction of a canopy's capacity that carries snow after `weather`, a function of seconds, has
/// lasted from `from_s` to `to_s`; `fraction` lay at first. In [0, 1].
///
/// Hedstrom and Pomeroy (1998, Hydrological Processes 12:1611, eq. 6 to 8), as a rate, with
/// unloading u: the cover C of the canopy, seen from above, catches what falls, the less the fuller
/// it is,
///   dI/dt = C P (1 - I / I_max) - u I,
/// so that after P in the cold I / I_max = 1 - exp(-C P / I_max). C = 1 - exp(-LAI / 2), leaves in
/// all directions. With leaf area indices of 1 to 3 it takes 3 to 6 mm to load a meadow by 0.8 to
/// 0.9. Solved exactly over steps of ten minutes, within which the weather is that of the middle.
double intercepted_fraction(double leaf_area_index, double fraction,
                            const std::function<CanopyWeather(double)>& weather, double from_s,
                            double to_s);

/// The fraction of the snow that the scene's grass can carry which lies on it in a frame (from 1),
/// in [0, 1]: of the weather at the terrain's zero since it began. Snow that lay on the ground then
/// (snow_cover.initial) had just fallen. 0 where snow_cover.cover is not "depth" and for fur.
/// `weather`: that of the scene's film.
double canopy_snow(const scene::Scene& scene, const snow::Weather& weather, int frame);

}  // namespace wold::meadow
