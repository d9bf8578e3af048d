#pragma once

#include "scene/calendar.h"

namespace wold::scene {

/// Whether any snow can fall in the film.
inline bool may_snow(const Scene& scene) {
  return scene.snowfall.strength != SnowfallStrength::weather ||
         scene.weather.precipitation_mm_h > 0.0 || !scene.weather.table.empty() || is_season(scene);
}

/// Whether any snow can lie on the ground in it.
inline bool may_lie(const Scene& scene) {
  return scene.snow_cover.cover != CoverModel::none &&
         (may_snow(scene) || scene.snow_cover.initial_mm > 0.0);
}

}  // namespace wold::scene
