#pragma once

#include "snow/weather.h"

namespace wold::snow {

/// Thickness of the ice on a lake at a time since the first frame, metres, by the weather that
/// there has been since it began: Stefan's law, by which its square grows by 1.24e-3 m2 for each
/// degree and day of frost ([Stefan]: 2 k / (L rho)), and 5 mm a degree and day of thaw, a usual
/// factor of degree-days. First the uppermost ten metres of the water have to cool, which lag the
/// air by 20 days; when the weather begins they are as warm as the air, not below 0. Snow on the
/// ice, which slows it, does not count. `height_m`: of the water over the terrain's zero.
double lake_ice_m(const Weather& weather, double time_s, double height_m);

}  // namespace wold::snow
