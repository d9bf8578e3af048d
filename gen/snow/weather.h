#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.h"

namespace wold::snow {

/// The weather at one moment, at the terrain's zero.
struct WeatherMoment {
  double temperature_c = 0.0;
  double precipitation_mm_h = 0.0;  ///< of water, snow or rain
  double wind_speed_m_s = 0.0;
  double wind_heading_deg = 0.0;  ///< where it blows to, clockwise from north
};

/// Temperature falls with height by the standard atmosphere's lapse rate.
inline constexpr double lapse_k_per_m = 0.0065;

/// Share of precipitation that is snow at an air temperature: 1 below 0, 0 above 2 degrees Celsius,
/// linear between (reference: half at 1 degree).
double snow_share(double temperature_c);

/// The scene's weather over time: constant as the keys of [weather], [wind] and
/// [snowfall] say, or linear between the rows of weather.table.
///
/// The table is comma-separated values with a header; columns by name, in any order: hours
/// (rising, since the weather began), and any of temperature_c, precipitation_mm_h,
/// wind_speed_m_s, wind_heading_deg (shorter way round). Before the first and after the last row
/// the nearest row holds.
class Weather {
 public:
  /// Throws InputError with file, line, what was found and what was expected: for a missing or
  /// unknown column, a number that is none or out of the range of the key it replaces (NaN,
  /// infinity, a negative rate), hours that do not rise.
  explicit Weather(const scene::Scene& scene);

  /// `time_s` since the first frame; negative down to -earlier_s().
  WeatherMoment at(double time_s) const;

  /// For how long the weather had lasted when the film starts.
  double earlier_s() const { return earlier_s_; }

  /// The way, east and north in metres, that the mean wind has blown since the weather began: the
  /// exact integral of at()'s wind as a piecewise linear vector.
  glm::dvec2 wind_way_m(double time_s) const;

 private:
  struct Row {
    double time_s;  ///< since the weather began
    WeatherMoment moment;
    glm::dvec2 way_m;  ///< the wind's, until then
  };
  std::vector<Row> rows_;  ///< one at least
  double earlier_s_ = 0.0;
};

}  // namespace wold::snow
