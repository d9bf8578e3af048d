#pragma once

#include <span>
#include <vector>

#include "weather/daily_weather.h"

namespace wold::phenology {

/// How a meadow answers to the weather: one set for all places.
///
/// The first six were fitted to the greenness that cameras measured in 2013 at four grasslands,
/// from cold prairie to Mediterranean pasture (tests/benchmark/fit_season.cpp; PhenoCam data of
/// Taylor and Browning 2021, Biogeosciences 18:2213); the others are choices, rounded from trials
/// with both years.
struct MeadowParameters {
  double cold_c = 2.60;        ///< mean temperature at which nothing grows
  double mild_c = 15.6;        ///< above which warmth limits nothing
  double hot_c = 28.7;         ///< above which heat limits
  double dry = 0.109;          ///< soil water, of its capacity, at which nothing grows
  double moist = 0.710;        ///< above which water limits nothing
  double rooting_days = 37.5;  ///< for how long plants feel the soil's water

  double deadly_heat_span_c = 8.0;  ///< from hot_c to where nothing grows
  double warmth_days = 30.0;        ///< for how long plants feel the temperature
  /// Day length: the ramp of the Growing Season Index (Jolly, Nemani and Running 2005) is 10 to 11.
  double short_day_h = 10.0;
  double long_day_h = 12.0;
  double capacity_mm = 40.0;      ///< water that roots reach, field capacity less wilting point
  double bare_evaporation = 0.4;  ///< of a bare soil, over that of a green meadow
  double growth_per_day = 0.2;
  double decay_per_day = 0.15;
  double seed = 0.3;  ///< growth of a dead meadow over that of a green one
};

/// Greenness of a meadow on each of the days, 0 dead to 1: how green it is beside the greenest day,
/// as cameras' green chromatic coordinate is scaled. Days of less than a year in all are told
/// beside the greenest meadow there can be.
///
/// Soil is a bucket that rain and melt fill and the green meadow empties (Hargreaves and Samani
/// 1985, evaporation from temperature); greenness strives for what warmth, day length and water
/// allow: the lesser of the first two times the last (the forms of Jolly and others 2005 and of
/// Hufkens and others 2016, Productivity of North American grasslands is increased under future
/// climate scenarios). The year before the first is taken to be like it.
std::vector<double> greenness(std::span<const weather::Day> days,
                              const MeadowParameters& meadow = {});

/// Water that a meadow could evaporate in a day, mm: 0.0023 Ra (T + 17.8) sqrt(tmax - tmin), with
/// Ra in mm of evaporation (Hargreaves and Samani 1985; FAO 56, equation 52).
double potential_evaporation_mm(const weather::Day& day);

/// The soil's water, the snow above it and where they go.
struct SoilWater {
  double soil_mm = 0.0;
  double snow_mm = 0.0;

  /// What left the soil.
  struct Loss {
    double evaporated_mm = 0.0;
    double drained_mm = 0.0;
  };
  /// A day's rain or snow, melt and evaporation. Nothing is lost but what is returned.
  Loss advance(const weather::Day& day, double potential_mm, double greenness,
               const MeadowParameters& meadow);
};

}  // namespace wold::phenology
