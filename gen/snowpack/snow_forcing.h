#pragma once

#include "snowpack/snow_layer.h"
#include "weather/daily_weather.h"

namespace wold::snowpack {

/// Snow on the ground advances in steps of so many hours, from six o'clock to six on the next day.
inline constexpr int snow_step_h = 3, snow_day_h = 6;

/// What snow asks of the weather besides temperature and precipitation.
struct SkyForcing {
  double phase_c = 0.0;    ///< the day's temperature that tells snow from rain
  double clearness = 1.0;  ///< these as in SnowForcing
  double sun_w_m2 = 0.0;
  double diffuse_w_m2 = 0.0;
  double slant_east_w_m2 = 0.0;
  double slant_north_w_m2 = 0.0;
};

/// A day from six to six.
///
/// Temperatures swing from its lowest at six to its highest at three and to the next day's lowest;
/// precipitation is spread evenly over the ground's day, and looks as it does while it falls; it is
/// rain or snow by the mean of these two temperatures (at Col de Porte that tells the snowfall that
/// was measured better than the day's own mean). The sun's light is that of
/// day length and latitude, half a wave between sunrise and sunset, through a sky as clear as the
/// swing is wide (Hargreaves and Samani 1982), diffuse as Erbs, Klein and Duffie (1982, Estimation
/// of the diffuse radiation fraction) have it for such a sky.
class DailyForcing {
 public:
  /// `latitude_deg` tells from where the sun shines on slopes.
  DailyForcing(const weather::Day& day, const weather::Day& next, double latitude_deg);

  /// `hour` in [6, 30], after the day's midnight.
  double temperature_c(double hour) const;
  double precipitation_mm_h() const { return precipitation_mm_h_; }
  /// The same over the hours in which it falls, Day::wet_h.
  double falling_mm_h() const { return falling_mm_h_; }
  SkyForcing sky(double hour) const;

 private:
  double sun_w_m2(double hour) const;

  double tmin_c_, tmax_c_, next_tmin_c_;
  double precipitation_mm_h_, falling_mm_h_;
  double day_length_h_;
  double transmitted_;  ///< fraction of the sun's light that comes through the air
  double mean_sun_w_m2_;
  double latitude_rad_, declination_rad_;
};

/// The air of some hours of weather, `cooler_k` cooler than there.
inline SnowForcing snow_forcing(double temperature_c, double precipitation_mm,
                                const SkyForcing& sky, double cooler_k = 0.0,
                                const SnowParameters& parameters = {}) {
  const double snow_mm = precipitation_mm * snow_fraction(sky.phase_c - cooler_k, parameters);
  return {.temperature_c = temperature_c - cooler_k,
          .snow_mm = snow_mm,
          .rain_mm = precipitation_mm - snow_mm,
          .sun_w_m2 = sky.sun_w_m2,
          .clearness = sky.clearness,
          .diffuse_w_m2 = sky.diffuse_w_m2,
          .slant_east_w_m2 = sky.slant_east_w_m2,
          .slant_north_w_m2 = sky.slant_north_w_m2};
}

}  // namespace wold::snowpack
