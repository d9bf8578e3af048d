#pragma once

#include <complex>
#include <memory>
#include <vector>

#include "scene/parts.h"
#include "weather/daily_weather.h"

namespace wold::phenology {

/// A wind beside that of [wind], for which the scene's clouds and the lean of its grass are given.
struct WindChange {
  double speed_factor = 1.0;
  double turned_rad = 0.0;  ///< clockwise, -pi to pi
};

/// The days of a scene's season, its weather and what it makes of the grass: season.table's, with
/// what [[season_keys]] say instead, and what neither says as in [weather] and [wind]. Only
/// film_season() makes one, and nobody copies it: a film has one, which is passed on.
class FilmSeason {
 public:
  FilmSeason(const FilmSeason&) = delete;
  FilmSeason& operator=(const FilmSeason&) = delete;

  /// One by one, without gaps: from at most a year before the first frame's day to a month after
  /// the last one's, as far as they are known, but these two at least.
  const std::vector<weather::Day>& days() const { return days_; }

  /// The first of days(), after the first frame's: negative or 0.
  int first_day() const { return first_day_; }

  /// Weathering degree of the grass at the terrain's mean place, by day.
  const std::vector<double>& weathering() const { return weathering_; }

  /// The same so many days after the first frame's: linear between days, held beyond them.
  double weathering_at(double days_after_first) const;

  /// How much of the clouds has gathered, in [0, 1], linear between days; 1 where nothing says so.
  double cloud_cover(double days_after_first) const;

  /// The wind, linear between days as a vector.
  WindChange wind(double days_after_first) const;
  /// The mean wind, as a vector, of the week that ends then: what has combed the grass.
  WindChange week_of_wind(double days_after_first) const;

  /// Visual range at the terrain's zero, m, through the air of a day, linear between days; what
  /// falls is not in it.
  double visual_range_m(double days_after_first) const;

 private:
  friend std::shared_ptr<const FilmSeason> film_season(const scene::SeasonPart& part);
  /// Of a scene that is a season.
  explicit FilmSeason(const scene::SeasonPart& part);

  /// Its absolute value is the factor, its argument the turn.
  using Change = std::complex<double>;

  std::vector<weather::Day> days_;
  int first_day_ = 0;
  std::vector<double> weathering_;
  std::vector<double> cloud_cover_;
  std::vector<Change> winds_, weeks_of_wind_;
  std::vector<double> unseen_per_m_;  ///< 1 / visual range
};

/// The season of a scene, to be made once for its film and shared; nullptr of a scene that is none.
/// Throws what read_daily_weather() throws; InputError when the table does not cover the film's
/// days.
std::shared_ptr<const FilmSeason> film_season(const scene::SeasonPart& part);

/// The scene as a film of ageing.frames and weather.earlier, which follow from its season, and with
/// season.frames of its shots. With nullptr, film_season() of a scene that is none, one without
/// shots stays as it is.
scene::Scene as_film(scene::Scene scene, const FilmSeason* season);

}  // namespace wold::phenology
