#include "scene/sun_path.h"

#include <algorithm>
#include <cmath>

#include "scene/calendar.h"

namespace wold::scene {
namespace {

SunPosition on_day(const Sun& sun, std::chrono::sys_days day) {
  return sun_position(day, sun.time_h, sun.latitude_deg, sun.longitude_deg);
}

/// A sun that stands there, `fraction` of the way from one place to another.
Sun between(Sun sun, const SunPosition& from, const SunPosition& to, double fraction) {
  const double turn_deg = std::remainder(to.azimuth_deg - from.azimuth_deg, 360.0);
  sun.date.clear();
  sun.end.clear();
  sun.elevation_deg = std::lerp(from.elevation_deg, to.elevation_deg, fraction);
  sun.azimuth_deg = from.azimuth_deg + turn_deg * fraction;
  return sun;
}

Sun standing(const Sun& sun, const SunPosition& there) { return between(sun, there, there, 0.0); }

/// At a moment of the clock of a season of shots.
Sun in_the_world(const Scene& scene, double time_s) {
  constexpr double day_s = 86400.0, hour_s = 3600.0;
  const double whole = std::floor(time_s / day_s);
  const std::chrono::sys_days day = std::chrono::sys_days(date_of(scene.season.first)) +
                                    std::chrono::days(static_cast<int>(whole));
  return standing(scene.sun, sun_position(day, (time_s - whole * day_s) / hour_s,
                                          scene.sun.latitude_deg, scene.sun.longitude_deg));
}

/// Where a moment lies between the earliest and the latest of all frames, in [0, 1].
double fraction_of_film(const Scene& scene, double time_s) {
  double earliest_s = scene.shots.front().start_s;
  for (const Shot& shot : scene.shots) earliest_s = std::min(earliest_s, shot.start_s);
  const double length_s = film_s(scene) - earliest_s;
  return length_s > 0.0 ? (time_s - earliest_s) / length_s : 0.0;
}

}  // namespace

bool sun_moves(const Scene& scene) { return is_season(scene) || !scene.sun.end.empty(); }

Sun sun_at(const Scene& scene, double time) {
  const Sun& sun = scene.sun;
  if (!sun_moves(scene)) return sun;
  if (!is_season(scene))
    return between(sun, {sun.elevation_deg, sun.azimuth_deg}, {sun.end[0], sun.end[1]}, time);
  const double days = time * season_length_days(scene.season);
  const double whole = std::floor(days);
  const std::chrono::sys_days before = std::chrono::sys_days(date_of(scene.season.first)) +
                                       std::chrono::days(static_cast<int>(whole));
  return between(sun, on_day(sun, before), on_day(sun, before + std::chrono::days(1)),
                 days - whole);
}

Sun sun_of_frame(const Scene& scene, int frame) {
  if (scene.shots.empty()) return sun_at(scene, way_of_frame(scene, frame));
  const double now_s = time_s(scene, frame);
  if (is_season(scene)) return in_the_world(scene, now_s);
  return sun_moves(scene) ? sun_at(scene, fraction_of_film(scene, now_s)) : scene.sun;
}

Sun sun_on_way(const Scene& scene, const Take& take, double way) {
  if (scene.shots.empty()) return sun_at(scene, way);
  const double steps = way * (take.count - 1);
  const int before = take.first + std::min(static_cast<int>(steps), std::max(0, take.count - 2));
  const Sun from = sun_of_frame(scene, before);
  if (take.count < 2 || !sun_moves(scene)) return from;
  const Sun to = sun_of_frame(scene, before + 1);
  return between(from, sun_position(from), sun_position(to), steps - (before - take.first));
}

}  // namespace wold::scene
