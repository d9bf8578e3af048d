#include "scene/sun_path.h"

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

}  // namespace

bool sun_moves(const Scene& scene) { return is_season(scene) || !scene.sun.end.empty(); }

Sun sun_at(const Scene& scene, double time) {
  const Sun& sun = scene.sun;
  if (!sun_moves(scene)) return sun;
  if (!is_season(scene))
    return between(sun, {sun.elevation_deg, sun.azimuth_deg}, {sun.end[0], sun.end[1]}, time);
  const double days = time * season_days(scene.season, scene.season.frames);
  const double whole = std::floor(days);
  const std::chrono::sys_days before = std::chrono::sys_days(date_of(scene.season.first)) +
                                       std::chrono::days(static_cast<int>(whole));
  return between(sun, on_day(sun, before), on_day(sun, before + std::chrono::days(1)),
                 days - whole);
}

}  // namespace wold::scene
