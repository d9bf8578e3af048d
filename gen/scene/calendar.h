#pragma once

#include <chrono>
#include <utility>

#include "scene/scene.h"
#include "scene/sun_position.h"

/// When frames are: a film has the clock of what moves, clouds, and that of the weather, which
/// withers grass and lets snow fall. They are the same but in a season, where days pass from frame
/// to frame.
namespace wold::scene {

inline bool is_season(const Season& season) { return !season.first.empty(); }
inline bool is_season(const Scene& scene) { return is_season(scene.season); }

/// Days from a season's first frame to a frame (from 1).
inline double season_days(const Season& season, int frame) {
  const auto days =
      (std::chrono::sys_days(date_of(season.last)) - std::chrono::sys_days(date_of(season.first)))
          .count();
  return static_cast<double>(days) * (frame - 1) / (season.frames - 1);
}

/// The weather's clock, since the first frame, at a frame (from 1).
inline double time_s(const Scene& scene, int frame) {
  constexpr double day_s = 86400.0;
  if (is_season(scene)) return season_days(scene.season, frame) * day_s;
  return (frame - 1) * scene.film.frame_seconds;
}

/// The clouds' clock in a season, since the first frame, on a day of it: frames are `frame_seconds`
/// (of [film]) apart for them, however many days pass.
inline double cloud_time_s(const Season& season, double frame_seconds,
                           const std::vector<std::int64_t>& date) {
  const auto days_from_first = [&](const std::vector<std::int64_t>& day) {
    return static_cast<double>(
        (std::chrono::sys_days(date_of(day)) - std::chrono::sys_days(date_of(season.first)))
            .count());
  };
  const double film_s = (season.frames - 1) * frame_seconds;
  return film_s * days_from_first(date) / days_from_first(season.last);
}

/// An event with start and duration as its days, if it has any, have them on that clock.
inline CloudEvent on_clock(const Season& season, double frame_seconds, CloudEvent event) {
  const auto time_s = [&](const std::vector<std::int64_t>& date) {
    return cloud_time_s(season, frame_seconds, date);
  };
  if (!event.date.empty()) event.start_s = time_s(event.date);
  if (!event.until.empty()) event.duration_s = time_s(event.until) - event.start_s;
  return event;
}
inline CloudEvent on_clock(const Scene& scene, CloudEvent event) {
  return on_clock(scene.season, scene.film.frame_seconds, std::move(event));
}

}  // namespace wold::scene
