#pragma once

#include "scene/scene.h"

namespace wold::scene {

/// Whether any snow can fall in the film.
inline bool may_snow(const Scene& scene) {
  return scene.snowfall.strength != "weather" || scene.weather.precipitation_mm_h > 0.0 ||
         !scene.weather.table.empty();
}

/// Whether any snow can lie on the ground in it.
inline bool may_lie(const Scene& scene) {
  return scene.snow_cover.cover != "none" && (may_snow(scene) || scene.snow_cover.initial_mm > 0.0);
}

/// The film's clock, since its first frame, at a frame (from 1).
inline double time_s(const Scene& scene, int frame) {
  return (frame - 1) * scene.film.frame_seconds;
}

}  // namespace wold::scene
