#include "snowpack/snow_forcing.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"
#include "weather/day_length.h"

namespace wold::snowpack {
namespace {

using std::numbers::pi;
constexpr double warmest_hour = 15.0, noon = 12.0, day_h = 24.0;
constexpr double clear_fraction = 0.75;  ///< of the sun's light that comes through clear air

/// From `from` at share 0 to `to` at 1, level at both.
double swung(double from, double to, double fraction) {
  return from + (to - from) * 0.5 * (1.0 - math::cos(pi * fraction));
}

/// Erbs, Klein and Duffie 1982, by the fraction of the sun's light that comes through the air.
double diffuse_fraction(double k) {
  if (k <= 0.22) return 1.0 - 0.09 * k;
  return 0.9511 + k * (-0.1604 + k * (4.388 + k * (-16.638 + k * 12.336)));  // up to 0.8
}

/// The direction to the sun's horizontal part over its height, east and north; no more than with
/// the sun 6 degrees high, where what air and hills leave of it is not known.
glm::dvec2 slant(double hour, double latitude_rad, double declination_rad) {
  constexpr double min_height = 0.1;
  const double angle = 2.0 * pi * (hour - noon) / day_h;
  const double sin_lat = math::sin(latitude_rad), cos_lat = math::cos(latitude_rad);
  const double sin_dec = math::sin(declination_rad), cos_dec = math::cos(declination_rad);
  const double height = sin_lat * sin_dec + cos_lat * cos_dec * math::cos(angle);
  return glm::dvec2(-cos_dec * math::sin(angle),
                    cos_lat * sin_dec - sin_lat * cos_dec * math::cos(angle)) /
         std::max(height, min_height);
}

}  // namespace

DailyForcing::DailyForcing(const weather::Day& day, const weather::Day& next, double latitude_deg)
    : tmin_c_(day.tmin_c),
      tmax_c_(day.tmax_c),
      next_tmin_c_(next.tmin_c),
      precipitation_mm_h_(day.precipitation_mm / day_h),
      falling_mm_h_(day.precipitation_mm / day.wet_h),
      day_length_h_(day.day_length_h),
      latitude_rad_(radians(latitude_deg)),
      declination_rad_(weather::declination_rad(weather::day_of_year(day.date))) {
  constexpr double hargreaves_per_sqrt_k = 0.16;  // inland
  constexpr double w_m2_per_mj_m2 = 1e6 / (day_h * 3600.0);
  transmitted_ = std::min(clear_fraction, hargreaves_per_sqrt_k * std::sqrt(tmax_c_ - tmin_c_));
  mean_sun_w_m2_ = transmitted_ * w_m2_per_mj_m2 * day.top_sun_mj_m2;
}

double DailyForcing::temperature_c(double hour) const {
  if (hour < warmest_hour)
    return swung(tmin_c_, tmax_c_, (hour - snow_day_h) / (warmest_hour - snow_day_h));
  return swung(tmax_c_, next_tmin_c_, (hour - warmest_hour) / (day_h + snow_day_h - warmest_hour));
}

double DailyForcing::sun_w_m2(double hour) const {
  const double from_noon = std::min(std::abs(hour - noon), std::abs(hour - noon - day_h));
  if (from_noon >= 0.5 * day_length_h_) return 0.0;
  return mean_sun_w_m2_ * 0.5 * pi * day_h / day_length_h_ *
         math::cos(pi * from_noon / day_length_h_);
}

SkyForcing DailyForcing::sky(double hour) const {
  const double sun = sun_w_m2(hour), diffuse = sun * diffuse_fraction(transmitted_);
  const glm::dvec2 slanting = (sun - diffuse) * slant(hour, latitude_rad_, declination_rad_);
  return {.phase_c = 0.5 * (tmax_c_ + next_tmin_c_),
          .clearness = transmitted_ / clear_fraction,
          .sun_w_m2 = sun,
          .diffuse_w_m2 = diffuse,
          .slant_east_w_m2 = slanting.x,
          .slant_north_w_m2 = slanting.y};
}

}  // namespace wold::snowpack
