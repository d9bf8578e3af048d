#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/parts.h"
#include "snowpack/snow_forcing.h"

namespace wold::phenology {
class FilmSeason;
}

namespace wold::snow {

/// The weather at one moment, at the terrain's zero.
struct WeatherMoment {
  double temperature_c = 0.0;
  double precipitation_mm_h = 0.0;  ///< of water, snow or rain
  double wind_speed_m_s = 0.0;
  double wind_heading_deg = 0.0;                 ///< where it blows to, clockwise from north
  std::optional<snowpack::SkyForcing> sky = {};  ///< in a season
  double falling_mm_h = 0.0;  ///< precipitation while it falls: in a season, for hours of a day
};

/// Temperature falls with height by the standard atmosphere's lapse rate.
inline constexpr double lapse_k_per_m = 0.0065;

/// Fraction of precipitation that is snow at an air temperature: 1 below 0, 0 above 2 degrees
/// Celsius, linear between: half at 1 degree, where as much falls as snow as as rain. It is the
/// rule for the temperature of the hour; snowpack::snow_fraction() is fitted to one of the day.
double snow_fraction(double temperature_c);

/// Fraction of it at a height above the terrain's zero: by its temperature, in a season by the
/// day's, snowpack::snow_fraction().
double snow_fraction(const WeatherMoment& weather, double height_m);

/// Snow that comes to the ground at a height above the terrain's zero, in mm of water per hour.
double snow_mm_h(const WeatherMoment& weather, double height_m);

/// The scene's weather over time: constant as the keys of [weather], [wind] and [snowfall] say, or
/// linear between the rows of weather.table; the wind as a vector. In a season it is that of the
/// days from six to six, snowpack::DailyForcing's every hour and a half and linear in between,
/// scene.weather.earlier being phenology::as_film()'s.
///
/// The table is comma-separated values with a header; columns by name, in any order: hours
/// (rising, since the weather began), and any of temperature_c, precipitation_mm_h,
/// wind_speed_m_s, wind_heading_deg. Before the first and after the last row the nearest row holds.
///
/// snowfall.strength "light", "moderate" and "blizzard" put 0.4, 1.2 or 4 mm/h in the place of all
/// precipitation and lower what is warmer than 0 degrees to that, so that all of it is snow.
class Weather {
 public:
  /// Throws InputError with file, line, column, what was found and what was expected, once for
  /// everything found: a missing, unknown or repeated column, a number that is none or out of the
  /// range of the key it replaces (NaN, infinity, a negative rate), hours that do not rise.
  /// Throws FileError when the table cannot be read.
  /// `season`: phenology::film_season() of the scene, nullptr where that is none.
  Weather(const scene::WeatherPart& part, const phenology::FilmSeason* season);

  /// `time_s` since the first frame; negative down to -earlier_s().
  WeatherMoment at(double time_s) const;

  /// For how long the weather had lasted when the film starts.
  double earlier_s() const { return earlier_s_; }

  /// The snow that comes to the ground at a time and height, see snow::snow_mm_h().
  double snow_mm_h(double time_s, double height_m) const;

  /// The same as one sees it fall, in mm of water per hour while it does.
  double falling_snow_mm_h(double time_s, double height_m) const;

  /// The rain that one sees fall at a time and height, in mm of water per hour while it does.
  double falling_rain_mm_h(double time_s, double height_m) const;

  /// The way, east and north in metres, that the mean wind has blown since the weather began: the
  /// exact integral of at()'s wind.
  glm::dvec2 wind_way_m(double time_s) const;

  /// How far it has blown since then, whichever way: the integral of its speed.
  double wind_run_m(double time_s) const;

  /// The highest rate of precipitation while it falls, in mm of water per hour.
  double heaviest_mm_h() const;

 private:
  struct Row {
    double time_s = 0.0;  ///< since the weather began
    WeatherMoment moment = {};
    glm::dvec2 wind_m_s{0.0};  ///< east and north
    glm::dvec2 way_m{0.0};     ///< the wind's, until then
    double run_m = 0.0;
  };
  /// What there is between two rows, or beyond the outer ones.
  struct Span {
    const Row& before;
    const Row& after;
    double fraction = 0.0;  ///< of the way from one to the other
    double beyond_s = 0.0;  ///< since the last row, or, negative, until the first
  };
  Span span_at(double time_s) const;
  static std::vector<Row> rows_of(const scene::WeatherPart& part,
                                  const phenology::FilmSeason* season);
  static std::vector<Row> rows_of_table(const scene::WeatherPart& part);
  static std::vector<Row> rows_of_season(const scene::WeatherPart& part,
                                         const phenology::FilmSeason& season);
  std::vector<Row> rows_;  ///< one at least
  double earlier_s_ = 0.0;
};

}  // namespace wold::snow
