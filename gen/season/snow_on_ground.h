#pragma once

#include <span>
#include <vector>

#include "season/daily_weather.h"

namespace wold::season {

/// How snow falls, settles and melts: one set for all places.
///
/// The first four were fitted to the snow that was measured at Col de Porte in the winters that
/// begin in odd years from 1993 to 2003 (tests/benchmark/fit_season.cpp; Lejeune and others 2019,
/// Earth System Science Data 11:71); the others are of the literature where it is named, or rounded
/// from trials with all of these winters.
struct SnowParameters {
  double half_snow_c = -0.143;     ///< at which as much falls as snow as as rain
  double viscosity_pa_s = 4.61e7;  ///< of snow without density at 0 degrees (Anderson 1976: 3.7e7)
  double longwave_loss_w_m2 = 121.0;  ///< of snow under a clear sky, net
  double chilled_share = 0.0927;      ///< of the surface's loss of heat that the pack feels

  double snow_span_c = 2.0;         ///< from all snow to all rain
  double exchange_w_m2_k = 6.0;     ///< of heat with the air, per degree
  double wet_softening = 5.0;       ///< viscosity of dry snow over that of wet
  double held_water = 0.05;         ///< share of the ice's mass (Essery 2015)
  double coldest_share = 0.03;      ///< heat that the ice can lack, over its heat of melting
  double albedo_fresh = 0.85;       ///< Essery 2015, A factorial snowpack model
  double albedo_old = 0.5;          ///< the same
  double ageing_cold_h = 1000.0;    ///< the same
  double ageing_melting_h = 300.0;  ///< 100 there
  double renewing_mm = 10.0;        ///< snowfall that makes a surface fresh, the same
};

/// Snow on level, open ground.
struct SnowOnGround {
  double depth_m = 0.0;
  double water_mm = 0.0;  ///< ice and liquid, kg/m2
};

/// The snow of each day as observers find it: at six in the morning, before what falls on that day.
/// There is none at the beginning.
///
/// A single layer of ice and held water, in steps of three hours from six to six. Temperatures
/// swing from a day's lowest at six to its highest at three and to the next day's lowest;
/// precipitation is spread evenly, rain or snow by the mean of these two (at Col de Porte that
/// tells the snowfall that was measured better than the day's own mean). Heat comes by the sun,
/// from day length and latitude through a sky as clear as the swing is wide (Hargreaves and Samani
/// 1982), less what the albedo reflects, from the air, from rain, and goes by longwave radiation.
/// Snow settles by Anderson's law (1976, A point energy and mass balance model of a snow cover),
/// fresh by Pahaut's 109 + 6 T.
std::vector<SnowOnGround> snow_on_ground(std::span<const Day> days,
                                         const SnowParameters& snow = {});

/// The pack and what goes in and out, for those who want to follow it.
class SnowLayer {
 public:
  explicit SnowLayer(const SnowParameters& parameters) : parameters_(parameters) {}

  double depth_m() const { return depth_m_; }
  double water_mm() const { return ice_mm_ + liquid_mm_; }
  double density_kg_m3() const { return depth_m_ > 0.0 ? water_mm() / depth_m_ : 0.0; }
  double albedo() const { return albedo_; }

  /// What the air does for some hours.
  struct Air {
    double temperature_c = 0.0;
    double snow_mm = 0.0;  ///< falls
    double rain_mm = 0.0;
    double sun_w_m2 = 0.0;   ///< on the level
    double clearness = 1.0;  ///< 0 overcast to 1
  };
  /// Returns the water that leaves the pack, mm: snow and rain = more water + what left.
  double advance(const Air& air, double hours);

 private:
  void take_snow(const Air& air);
  void age_surface(const Air& air, double hours);
  double warmed_by_mm(const Air& air, double hours) const;
  double melted(double heat_mm);
  void chill(double loss_mm);
  void drain();
  void settle(const Air& air, double hours);
  void vanish();

  const SnowParameters& parameters_;
  double ice_mm_ = 0.0;
  double liquid_mm_ = 0.0;
  double depth_m_ = 0.0;
  double lacking_mm_ = 0.0;  ///< melt that the heat would make which the pack needs to be at 0
  double albedo_ = 0.85;
};

}  // namespace wold::season
