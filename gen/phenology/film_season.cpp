#include "phenology/film_season.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/angle.h"
#include "core/complex_plane.h"
#include "core/elementary.h"
#include "core/error.h"
#include "phenology/greenness.h"
#include "phenology/withering.h"
#include "scene/calendar.h"
#include "scene/shots.h"
#include "scene/text.h"
#include "weather/day_length.h"

namespace wold::phenology {
namespace {

using std::chrono::days;
using std::chrono::sys_days;

/// Snow and soil remember no more than this before the film; places that are ahead of the mean one
/// need days after it.
constexpr days max_before(366), max_after(31);
constexpr double hours_per_day = 24.0;
/// Half the difference of day's and night's temperature, where only the mean is known.
constexpr double diurnal_k = 4.0;

sys_days first_of(const scene::SeasonPart& part) { return scene::date_of(part.season.first); }
sys_days last_of(const scene::SeasonPart& part) { return scene::date_of(part.season.last); }

double days_between(sys_days from, sys_days to) { return static_cast<double>((to - from).count()); }

/// The days of the film, as [weather] and [wind] have them.
std::vector<weather::Day> plain_days(const scene::SeasonPart& part) {
  const double latitude_deg = part.latitude_deg;
  std::vector<weather::Day> plain;
  for (sys_days date = first_of(part); date <= last_of(part); date += days(1)) {
    const double mean_c = part.weather.temperature_c;
    plain.push_back(
        {.date = date,
         .tmin_c = mean_c - diurnal_k,
         .tmax_c = mean_c + diurnal_k,
         .precipitation_mm = part.weather.precipitation_mm_h * hours_per_day,
         .day_length_h = weather::day_length_h(weather::day_of_year(date), latitude_deg),
         .top_sun_mj_m2 = weather::extraterrestrial_mj_m2(weather::day_of_year(date), latitude_deg),
         .wind_speed_m_s = part.wind.speed_m_s,
         .wind_heading_deg = part.wind.heading_deg,
         .cloud_cover = {},
         .visual_range_m = {}});
  }
  return plain;
}

/// The table's days about the film's.
std::vector<weather::Day> table_days(const scene::SeasonPart& part) {
  const std::string& file = part.season.table;
  std::vector<weather::Day> all = weather::read_daily_weather(file, part.latitude_deg);
  if (all.front().date > first_of(part) || all.back().date < last_of(part))
    throw InputError(fmt::format(
        "{}: found days from {:%Y-%m-%d} to {:%Y-%m-%d}, expected all from season.first "
        "({:%Y-%m-%d}) to season.last ({:%Y-%m-%d})",
        file, all.front().date, all.back().date, first_of(part), last_of(part)));
  std::erase_if(all, [&](const weather::Day& day) {
    return day.date < first_of(part) - max_before || day.date > last_of(part) + max_after;
  });
  return all;
}

/// A quantity of [[season_keys]]: linear between the days that give it.
class KeyCurve {
 public:
  KeyCurve(const scene::SeasonPart& part, std::optional<double> scene::SeasonKey::*field) {
    for (const scene::SeasonKey& key : part.keys)
      if (key.*field)
        points_.emplace_back(days_between(first_of(part), scene::date_of(key.date)), *(key.*field));
  }
  /// The same of an angle in degrees, which turns the shorter way.
  static KeyCurve turning(const scene::SeasonPart& part,
                          std::optional<double> scene::SeasonKey::*field) {
    KeyCurve curve(part, field);
    double before = 0.0;
    for (auto& [day, angle] : curve.points_)
      before = angle = before + std::remainder(angle - before, 360.0);
    return curve;
  }

  bool is_given() const { return !points_.empty(); }

  double at(double day) const {
    const auto after =
        std::ranges::upper_bound(points_, day, {}, &std::pair<double, double>::first);
    if (after == points_.begin()) return after->second;
    const auto& [from, before] = *(after - 1);
    if (after == points_.end()) return before;
    return std::lerp(before, after->second, (day - from) / (after->first - from));
  }

 private:
  std::vector<std::pair<double, double>> points_;  ///< day after the first frame's, value
};

/// The same direction in [0, 360).
double from_north_deg(double turned_deg) {
  return turned_deg - 360.0 * std::floor(turned_deg / 360.0);
}

/// What keys say wins.
void set_by_keys(std::vector<weather::Day>& all, const scene::SeasonPart& part) {
  using Key = scene::SeasonKey;
  const KeyCurve temperature(part, &Key::temperature_c);
  const KeyCurve precipitation(part, &Key::precipitation_mm_day);
  const KeyCurve cloud_cover(part, &Key::cloud_cover);
  const KeyCurve wind_speed(part, &Key::wind_speed_m_s);
  const KeyCurve wind_heading = KeyCurve::turning(part, &Key::wind_heading_deg);
  const KeyCurve visual_range(part, &Key::visual_range_m);
  for (weather::Day& day : all) {
    const double at = days_between(first_of(part), day.date);
    if (temperature.is_given()) {
      const double half_k = 0.5 * (day.tmax_c - day.tmin_c);
      day.tmin_c = temperature.at(at) - half_k;
      day.tmax_c = temperature.at(at) + half_k;
    }
    if (precipitation.is_given()) {
      day.precipitation_mm = precipitation.at(at);
      day.wet_h = weather::wet_hours(day.precipitation_mm);
    }
    if (cloud_cover.is_given()) day.cloud_cover = cloud_cover.at(at);
    if (wind_speed.is_given()) day.wind_speed_m_s = wind_speed.at(at);
    if (wind_heading.is_given()) day.wind_heading_deg = from_north_deg(wind_heading.at(at));
    if (visual_range.is_given()) day.visual_range_m = visual_range.at(at);
    if (!day.wind_speed_m_s) day.wind_speed_m_s = part.wind.speed_m_s;
    if (!day.wind_heading_deg) day.wind_heading_deg = part.wind.heading_deg;
    if (!day.visual_range_m) day.visual_range_m = part.visual_range_m;
  }
}

std::vector<double> weathering_of(const scene::SeasonPart& part,
                                  const std::vector<weather::Day>& all) {
  const KeyCurve keys(part, &scene::SeasonKey::weathering);
  if (!keys.is_given()) return weathering_degrees(greenness(all));
  std::vector<double> degrees;
  degrees.reserve(all.size());
  for (const weather::Day& day : all)
    degrees.push_back(keys.at(days_between(first_of(part), day.date)));
  return degrees;
}

/// Of a season without wind in [wind], only where it blows to counts.
std::vector<std::complex<double>> wind_changes(const std::vector<weather::Day>& all,
                                               const scene::Wind& usual) {
  std::vector<std::complex<double>> changes;
  changes.reserve(all.size());
  for (const weather::Day& day : all)
    changes.push_back(
        from_polar(usual.speed_m_s > 0.0 ? *day.wind_speed_m_s / usual.speed_m_s : 1.0,
                   radians(*day.wind_heading_deg - usual.heading_deg)));
  return changes;
}

/// Means over a week, or over as much of it as is known.
std::vector<std::complex<double>> of_weeks(const std::vector<std::complex<double>>& by_day) {
  constexpr std::size_t week = 7;
  std::vector<std::complex<double>> means;
  for (std::size_t day = 0; day < by_day.size(); ++day) {
    const std::size_t count = std::min(day + 1, week);
    const auto end = by_day.begin() + static_cast<std::ptrdiff_t>(day) + 1;
    means.push_back(
        std::accumulate(end - static_cast<std::ptrdiff_t>(count), end, std::complex<double>()) /
        static_cast<double>(count));
  }
  return means;
}

WindChange change_of(const std::complex<double>& wind) { return {length_of(wind), angle_of(wind)}; }

/// What is so `day` days after the first of two at least: linear between them, held beyond.
template <class Value>
Value at_day(double day, const std::vector<Value>& by_day) {
  const double place = std::clamp(day, 0.0, static_cast<double>(by_day.size() - 1));
  const auto before = std::min(static_cast<std::size_t>(place), by_day.size() - 2);
  return by_day[before] +
         (by_day[before + 1] - by_day[before]) * (place - static_cast<double>(before));
}

}  // namespace

FilmSeason::FilmSeason(const scene::SeasonPart& part)
    : days_(part.season.table.empty() ? plain_days(part) : table_days(part)),
      first_day_(static_cast<int>((days_.front().date - first_of(part)).count())) {
  set_by_keys(days_, part);
  weathering_ = weathering_of(part, days_);
  winds_ = wind_changes(days_, part.wind);
  weeks_of_wind_ = of_weeks(winds_);
  for (std::size_t i = 0; i < days_.size(); ++i) {
    cloud_cover_.push_back(days_[i].cloud_cover.value_or(1.0));
    unseen_per_m_.push_back(1.0 / *days_[i].visual_range_m);
  }
}

double FilmSeason::weathering_at(double days_after_first) const {
  return at_day(days_after_first - first_day_, weathering_);
}

double FilmSeason::cloud_cover(double days_after_first) const {
  return at_day(days_after_first - first_day_, cloud_cover_);
}

WindChange FilmSeason::wind(double days_after_first) const {
  return change_of(at_day(days_after_first - first_day_, winds_));
}

WindChange FilmSeason::week_of_wind(double days_after_first) const {
  return change_of(at_day(days_after_first - first_day_, weeks_of_wind_));
}

double FilmSeason::visual_range_m(double days_after_first) const {
  return 1.0 / at_day(days_after_first - first_day_, unseen_per_m_);
}

std::shared_ptr<const FilmSeason> film_season(const scene::SeasonPart& part) {
  if (!scene::is_season(part.season)) return nullptr;
  return std::shared_ptr<const FilmSeason>(new FilmSeason(part));
}

scene::Scene as_film(scene::Scene scene, const FilmSeason* season) {
  scene::take_frames_of_shots(scene);
  if (season == nullptr) return scene;
  scene.ageing.frames.clear();
  for (int frame = 1; frame <= scene.season.frames; ++frame)
    scene.ageing.frames.push_back(season->weathering_at(scene::season_days(scene, frame)));
  scene.weather.earlier_h = -hours_per_day * season->first_day() + scene::clock_begins_h(scene);
  return scene;
}

}  // namespace wold::phenology
