#pragma once

#include <array>

#include "scene/scene.h"

namespace wold::test {

// The canopy that light in texels is held against: the default meadow on level ground.

inline constexpr std::array canopy_weathering_degrees = {0.0, 0.30, 0.60, 0.917};
inline constexpr std::array canopy_suns_deg = {20.0, 40.0, 60.0};
/// From the vertical; negative ones look at the meadow with the sun behind them.
inline constexpr std::array canopy_views_deg = {-75, -60, -45, -30, -15, 0, 15, 30, 45, 60, 75};

/// Default keys, the sun in the south at an elevation.
inline scene::Scene canopy_scene(double sun_deg) {
  scene::Scene scene;
  scene.sun.azimuth_deg = 180.0;
  scene.sun.elevation_deg = sun_deg;
  return scene;
}

}  // namespace wold::test
