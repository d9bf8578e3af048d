#include "scene/calendar.h"

#include <algorithm>
#include <utility>

#include "scene/shots.h"

namespace wold::scene {
namespace {

constexpr double day_s = 86400.0, hour_s = 3600.0;

double days_between(const std::vector<std::int64_t>& from, const std::vector<std::int64_t>& to) {
  return static_cast<double>(
      (std::chrono::sys_days(date_of(to)) - std::chrono::sys_days(date_of(from))).count());
}

/// When a shot begins, on the scene's clock.
double begin_s(const Scene& scene, const Shot& shot) {
  if (!is_season(scene)) return shot.start_s;
  return days_between(scene.season.first, shot.date) * day_s +
         shot.time_h.value_or(scene.sun.time_h) * hour_s;
}

}  // namespace

double season_length_days(const Season& season) { return days_between(season.first, season.last); }

double clock_begins_h(const Scene& scene) { return scene.shots.empty() ? scene.sun.time_h : 0.0; }

double time_s(const Scene& scene, int frame) {
  if (const Shot* shot = shot_of(scene, frame))
    return begin_s(scene, *shot) + (frame - take_of(scene, frame).first) * shot->frame_seconds;
  if (is_season(scene)) return season_days(scene, frame) * day_s;
  return (frame - 1) * scene.film.frame_seconds;
}

double film_s(const Scene& scene) {
  double latest_s = 0.0;
  for (const Take& take : takes_of(scene))
    latest_s = std::max(latest_s, time_s(scene, take.last()));
  return latest_s;
}

double season_days(const Scene& scene, int frame) {
  constexpr double noon = 0.5;
  if (!scene.shots.empty()) return time_s(scene, frame) / day_s - noon;
  return season_length_days(scene.season) * (frame - 1) / (scene.season.frames - 1);
}

bool is_time_lapse(const Scene& scene, int frame) {
  if (!is_season(scene)) return false;
  const Shot* shot = shot_of(scene, frame);
  return shot == nullptr || shot->frame_seconds >= hour_s;
}

double cloud_step_s(const Scene& scene, int frame) {
  const Shot* shot = shot_of(scene, frame);
  if (shot == nullptr || is_time_lapse(scene, frame)) return scene.film.frame_seconds;
  return shot->frame_seconds;
}

double cloud_time_s(const Scene& scene, int frame) {
  const int first = take_of(scene, frame).first;
  const double begins_s = scene.shots.empty() ? 0.0 : time_s(scene, first);
  return begins_s + (frame - first) * cloud_step_s(scene, frame);
}

double cloud_season_s(const Scene& scene) {
  if (!is_season(scene)) return 0.0;
  if (!scene.shots.empty()) return season_length_days(scene.season) * day_s;
  return (scene.season.frames - 1) * scene.film.frame_seconds;
}

double cloud_time_s(const Season& season, double cloud_season_s,
                    const std::vector<std::int64_t>& date) {
  return cloud_season_s * days_between(season.first, date) / season_length_days(season);
}

CloudEvent on_clock(const Season& season, double cloud_season_s, CloudEvent event) {
  if (event.date.empty()) return event;
  const auto time_s = [&](const std::vector<std::int64_t>& date) {
    return cloud_time_s(season, cloud_season_s, date);
  };
  event.start_s = time_s(event.date);
  if (!event.until.empty()) event.duration_s = time_s(event.until) - event.start_s;
  return event;
}

CloudEvent on_clock(const Scene& scene, CloudEvent event) {
  if (event.date.empty()) return event;
  return on_clock(scene.season, cloud_season_s(scene), std::move(event));
}

}  // namespace wold::scene
