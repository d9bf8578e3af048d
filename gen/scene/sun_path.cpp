#include "scene/sun_path.h"

#include <cmath>

#include "scene/calendar.h"

namespace wold::scene {
namespace {

SunPosition on_day(const Sun& sun, std::chrono::sys_days day) {
  return sun_position(day, sun.time_h, sun.latitude_deg, sun.longitude_deg);
}

}  // namespace

Sun sun_at(const Scene& scene, double time) {
  Sun sun = scene.sun;
  if (!is_season(scene)) return sun;
  const double days = time * season_days(scene.season, scene.season.frames);
  const double whole = std::floor(days);
  const std::chrono::sys_days before = std::chrono::sys_days(date_of(scene.season.first)) +
                                       std::chrono::days(static_cast<int>(whole));
  const SunPosition from = on_day(sun, before);
  const SunPosition to = on_day(sun, before + std::chrono::days(1));
  const double turn_deg = std::remainder(to.azimuth_deg - from.azimuth_deg, 360.0);
  sun.date.clear();
  sun.elevation_deg = std::lerp(from.elevation_deg, to.elevation_deg, days - whole);
  sun.azimuth_deg = from.azimuth_deg + turn_deg * (days - whole);
  return sun;
}

}  // namespace wold::scene
