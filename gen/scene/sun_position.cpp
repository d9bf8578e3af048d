#include "scene/sun_position.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/elementary.h"

namespace wold::scene {
namespace {

double sin_deg(double angle_deg) { return math::sin(angle_deg * radians_per_degree); }
double cos_deg(double angle_deg) { return math::cos(angle_deg * radians_per_degree); }
double tan_deg(double angle_deg) { return math::tan(angle_deg * radians_per_degree); }
double atan2_deg(double y, double x) { return math::atan2(y, x) / radians_per_degree; }

/// Julian centuries since 2000 January 1, noon.
double centuries_since_2000(const std::chrono::year_month_day& date, double hours_utc) {
  constexpr std::chrono::sys_days start = std::chrono::January / 1 / 2000;
  const auto days = static_cast<double>((std::chrono::sys_days(date) - start).count());
  return (days + (hours_utc - 12.0) / 24.0) / 36525.0;
}

double mean_longitude_deg(double t) { return 280.46646 + t * (36000.76983 + t * 0.0003032); }
double mean_anomaly_deg(double t) { return 357.52911 + t * (35999.05029 - t * 0.0001537); }
double moon_node_deg(double t) { return 125.04 - 1934.136 * t; }

/// True less mean longitude, of the ellipse.
double equation_of_centre_deg(double t) {
  const double anomaly_deg = mean_anomaly_deg(t);
  return (1.914602 - t * (0.004817 + t * 0.000014)) * sin_deg(anomaly_deg) +
         (0.019993 - t * 0.000101) * sin_deg(2.0 * anomaly_deg) +
         0.000289 * sin_deg(3.0 * anomaly_deg);
}

/// In longitude, the largest term.
double nutation_deg(double t) { return -0.00478 * sin_deg(moon_node_deg(t)); }

/// For the apparent place.
double obliquity_deg(double t) {
  return 23.439291 - 0.0130042 * t + 0.00256 * cos_deg(moon_node_deg(t));
}

struct Apparent {
  double declination_deg;
  double equation_of_time_deg;  // apparent less mean solar time, up to whole turns
};

/// Meeus, chapter 25, and the equation of time by 28.1.
Apparent apparent_sun(double t) {
  constexpr double aberration_deg = 0.00569;
  const double longitude_deg =
      mean_longitude_deg(t) + equation_of_centre_deg(t) - aberration_deg + nutation_deg(t);
  const double tilt_deg = obliquity_deg(t);
  const double right_ascension_deg =
      atan2_deg(cos_deg(tilt_deg) * sin_deg(longitude_deg), cos_deg(longitude_deg));
  return {math::asin(sin_deg(tilt_deg) * sin_deg(longitude_deg)) / radians_per_degree,
          mean_longitude_deg(t) - 0.0057183 - right_ascension_deg +
              nutation_deg(t) * cos_deg(tilt_deg)};
}

/// Saemundsson 1986 (Sky and Telescope 72, 70; Meeus 16.4), for an elevation without air.
double refraction_above_deg(double elevation_deg) {
  const double minutes = 1.02 / tan_deg(elevation_deg + 10.3 / (elevation_deg + 5.11));
  return std::max(minutes / 60.0, 0.0);
}

/// Below the horizon the formula soon fails: from where the sun is seen to set, the refraction
/// tapers off as the cotangent (as in NOAA's solar calculator), to nothing at the nadir.
double refraction_deg(double elevation_deg) {
  constexpr double setting_deg = -0.575;
  if (elevation_deg >= setting_deg) return refraction_above_deg(elevation_deg);
  return refraction_above_deg(setting_deg) * tan_deg(setting_deg) / tan_deg(elevation_deg);
}

/// Into [0, 360), where the rounding of a tiny negative angle must not give 360.
double compass_deg(double azimuth_deg) {
  const double turned_deg = azimuth_deg < 0.0 ? azimuth_deg + 360.0 : azimuth_deg;
  return turned_deg < 360.0 ? turned_deg : 0.0;
}

SunPosition seen_from(double latitude_deg, double hour_angle_deg, double declination_deg) {
  const double to_equator = cos_deg(declination_deg) * cos_deg(hour_angle_deg);
  const double to_pole = sin_deg(declination_deg);
  const double east = -cos_deg(declination_deg) * sin_deg(hour_angle_deg);
  const double north = cos_deg(latitude_deg) * to_pole - sin_deg(latitude_deg) * to_equator;
  const double up = sin_deg(latitude_deg) * to_pole + cos_deg(latitude_deg) * to_equator;
  const double elevation_deg = atan2_deg(up, math::hypot(east, north));
  return {elevation_deg + refraction_deg(elevation_deg), compass_deg(atan2_deg(east, north))};
}

}  // namespace

SunPosition sun_position(const std::chrono::year_month_day& date, double hours_utc,
                         double latitude_deg, double longitude_deg) {
  const Apparent sun = apparent_sun(centuries_since_2000(date, hours_utc));
  const double hour_angle_deg =
      15.0 * (hours_utc - 12.0) + longitude_deg + sun.equation_of_time_deg;
  return seen_from(latitude_deg, hour_angle_deg, sun.declination_deg);
}

std::chrono::year_month_day date_of(const std::vector<std::int64_t>& numbers) {
  return {std::chrono::year(static_cast<int>(numbers[0])),
          std::chrono::month(static_cast<unsigned>(numbers[1])),
          std::chrono::day(static_cast<unsigned>(numbers[2]))};
}

SunPosition sun_position(const Sun& sun) {
  if (sun.date.empty()) return {sun.elevation_deg, sun.azimuth_deg};
  return sun_position(date_of(sun.date), sun.time_h, sun.latitude_deg, sun.longitude_deg);
}

}  // namespace wold::scene
