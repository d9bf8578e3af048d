#pragma once

#include <algorithm>

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

/// The least wind that lifts snow, m/s: snow::lifting_wind_m_s()'s lowest.
inline constexpr double min_lifting_wind_m_s = 6.9;

/// The strongest mean wind that the scene's keys name, m/s.
inline double strongest_wind_m_s(const Scene& scene) {
  double strongest_m_s = scene.wind.speed_m_s;
  for (const SeasonKey& key : scene.season_keys)
    strongest_m_s = std::max(strongest_m_s, key.wind_speed_m_s.value_or(0.0));
  return strongest_m_s;
}

/// As strong as the wind of a place and a moment is at most, over the mean wind: on a crest, in a
/// gust.
inline constexpr double strongest_over_mean = 4.0;

/// Whether wind may lift snow from the ground in it: that of a table, or one that hills and gusts
/// make as strong as it takes.
inline bool may_blow(const Scene& scene) {
  const bool has_table = !scene.weather.table.empty() || !scene.season.table.empty();
  return scene.snow_cover.cover == CoverModel::depth && scene.snow_cover.blowing > 0.0 &&
         may_lie(scene) &&
         (has_table || strongest_over_mean * strongest_wind_m_s(scene) > min_lifting_wind_m_s);
}

/// Whether the scene's keys name a wind that lifts snow on level ground, in usual gusts.
inline bool is_stormy(const Scene& scene) {
  return may_blow(scene) &&
         (1.0 + 2.0 * scene.wind.turbulence) * strongest_wind_m_s(scene) > min_lifting_wind_m_s;
}

}  // namespace wold::scene
