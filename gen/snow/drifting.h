#pragma once

#include "core/ground_map.h"
#include "snow/weather.h"

namespace wold::snow {

/// How far wind is felt to be kept off by what stands upwind.
inline constexpr double farthest_shelter_m = 100.0;

/// Sx, degrees: the steepest rise from a place to the ground upwind of it, within 100 m and 15
/// degrees of the wind on either side, by rays 5 degrees apart (Winstral, Elder and Davis 2002,
/// Spatial snow modeling of wind-redistributed snow using terrain-based parameters, which has 30
/// degrees on either side). Positive in the lee, negative where the ground upwind is lower; 0 at
/// the border where wind comes from outside the map.
/// heading_deg: where the wind blows to, clockwise from north. Rays look at every step of the map
/// up to 16 of them, then at every eighth of the distance.
FactorMap shelter_deg(const Heightfield& terrain, double heading_deg);

/// Snowfall in a place of shelter over that in the open: 1 + drifting tanh(Sx / 15 degrees).
double drift_weight(double shelter_deg, double drifting);

/// drift_weight() of every place.
FactorMap drift_weights(const Heightfield& terrain, double heading_deg, double drifting);

/// drift_weights() over their mean on the map: wind moves snow and makes none.
FactorMap drift_factor(const Heightfield& terrain, double heading_deg, double drifting);

/// The heading of a wind to 15 degrees, in [0, 360): drifts are reckoned for so many winds. -1
/// where nothing drifts.
int drift_heading_deg(const WeatherMoment& weather, double drifting);

}  // namespace wold::snow
