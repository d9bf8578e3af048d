#include "snow/weather.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/elementary.h"
#include "phenology/film_season.h"
#include "scene/registry.h"
#include "weather/number_table.h"

namespace wold::snow {
namespace {

constexpr double seconds_per_hour = 3600.0;

weather::TableColumn column_like(const char* name, const char* key_name) {
  const scene::Key& key = *scene::find_key(key_name);
  return {.name = name, .lowest = key.lowest, .highest = key.highest, .unit = key.unit};
}

glm::dvec2 wind_of(const WeatherMoment& moment) {
  const double heading = glm::radians(moment.wind_heading_deg);
  return moment.wind_speed_m_s * glm::dvec2(math::sin(heading), math::cos(heading));
}

double heading_deg(const glm::dvec2& wind) {
  const double heading = glm::degrees(math::atan2(wind.x, wind.y));
  return heading < 0.0 ? heading + 360.0 : heading;
}

WeatherMoment of_keys(const scene::WeatherPart& part) {
  return {.temperature_c = part.weather.temperature_c,
          .precipitation_mm_h = part.weather.precipitation_mm_h,
          .wind_speed_m_s = part.wind.speed_m_s,
          .wind_heading_deg = part.wind.heading_deg,
          .falling_mm_h = part.weather.precipitation_mm_h};
}

/// A fraction of the way from one to the other.
std::optional<snowpack::SkyForcing> between(const std::optional<snowpack::SkyForcing>& a,
                                            const std::optional<snowpack::SkyForcing>& b,
                                            double fraction) {
  if (!a || !b) return {};
  return snowpack::SkyForcing{
      .phase_c = std::lerp(a->phase_c, b->phase_c, fraction),
      .clearness = std::lerp(a->clearness, b->clearness, fraction),
      .sun_w_m2 = std::lerp(a->sun_w_m2, b->sun_w_m2, fraction),
      .diffuse_w_m2 = std::lerp(a->diffuse_w_m2, b->diffuse_w_m2, fraction),
      .slant_east_w_m2 = std::lerp(a->slant_east_w_m2, b->slant_east_w_m2, fraction),
      .slant_north_w_m2 = std::lerp(a->slant_north_w_m2, b->slant_north_w_m2, fraction)};
}

/// How much water snow of that strength brings, in mm/h; none: as much as the weather does.
std::optional<double> rate_of(scene::SnowfallStrength strength) {
  switch (strength) {
    case scene::SnowfallStrength::weather:
      return std::nullopt;
    case scene::SnowfallStrength::light:
      return 0.4;
    case scene::SnowfallStrength::moderate:
      return 1.2;
    case scene::SnowfallStrength::blizzard:
      return 4.0;
  }
  return std::nullopt;
}

/// What snowfall.strength makes of the weather.
WeatherMoment with_strength(WeatherMoment moment, scene::SnowfallStrength strength) {
  const std::optional<double> rate_mm_h = rate_of(strength);
  if (!rate_mm_h) return moment;
  moment.precipitation_mm_h = moment.falling_mm_h = *rate_mm_h;
  moment.temperature_c = std::min(moment.temperature_c, 0.0);
  if (moment.sky) moment.sky->phase_c = std::min(moment.sky->phase_c, snowpack::all_snow_c);
  return moment;
}

/// The integral of |a + (b - a) x| for x in [0, share], times `duration_s`: the exact length of the
/// way in a wind that changes evenly.
double run_of(const glm::dvec2& a, const glm::dvec2& b, double fraction, double duration_s) {
  const glm::dvec2 change = b - a;
  const double c = glm::length(change);
  if (c <= 1e-9 * (glm::length(a) + glm::length(b))) return glm::length(a) * fraction * duration_s;
  // Along the change the wind is c x + s, across it h.
  const double s = glm::dot(a, change) / c;
  const double h = std::abs(a.x * change.y - a.y * change.x) / c;
  const auto integral = [&](double along) {
    const double speed = math::hypot(along, h);
    return 0.5 * (along * speed + (h > 0.0 ? h * h * math::asinh(along / h) : 0.0));
  };
  return (integral(s + c * fraction) - integral(s)) / c * duration_s;
}

}  // namespace

double snow_fraction(double temperature_c) {
  return std::clamp(1.0 - 0.5 * temperature_c, 0.0, 1.0);
}

double snow_fraction(const WeatherMoment& weather, double height_m) {
  const double cooler_k = lapse_k_per_m * height_m;
  return weather.sky ? snowpack::snow_fraction(weather.sky->phase_c - cooler_k)
                     : snow_fraction(weather.temperature_c - cooler_k);
}

double snow_mm_h(const WeatherMoment& weather, double height_m) {
  return weather.precipitation_mm_h * snow_fraction(weather, height_m);
}

std::vector<Weather::Row> Weather::rows_of_table(const scene::WeatherPart& part) {
  const auto table =
      weather::read_table(part.weather.table,
                          {{.name = "hours", .unit = "h", .rises = true, .required = true},
                           column_like("temperature_c", "weather.temperature"),
                           column_like("precipitation_mm_h", "weather.precipitation"),
                           column_like("wind_speed_m_s", "wind.speed"),
                           column_like("wind_heading_deg", "wind.heading")})
          .columns;
  std::vector<Row> rows(table[0].size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    WeatherMoment& moment = rows[i].moment;
    moment = of_keys(part);
    rows[i].time_s = seconds_per_hour * table[0][i];
    const std::array fields = {&moment.temperature_c, &moment.precipitation_mm_h,
                               &moment.wind_speed_m_s, &moment.wind_heading_deg};
    for (std::size_t field = 0; field < fields.size(); ++field)
      if (!table[field + 1].empty()) *fields[field] = table[field + 1][i];
    moment.falling_mm_h = moment.precipitation_mm_h;
  }
  return rows;
}

/// Every hour and a half, so that the middles of the snow's steps are among them.
std::vector<Weather::Row> Weather::rows_of_season(const scene::WeatherPart& part,
                                                  const phenology::FilmSeason& season) {
  constexpr double day_h = 24.0, row_h = 0.5 * snowpack::snow_step_h, moment_h = 0.01;
  const std::vector<weather::Day>& days = season.days();
  std::vector<Row> rows;
  for (std::size_t i = 0; i < days.size(); ++i) {
    const weather::Day& day = days[i];
    const snowpack::DailyForcing air(day, days[std::min(i + 1, days.size() - 1)],
                                     part.latitude_deg);
    const auto add = [&](double hour) {
      rows.push_back(
          {.time_s = (day_h * static_cast<double>(i) + hour) * seconds_per_hour,
           .moment = {.temperature_c = air.temperature_c(hour),
                      .precipitation_mm_h = air.precipitation_mm_h(),
                      .wind_speed_m_s = day.wind_speed_m_s.value_or(part.wind.speed_m_s),
                      .wind_heading_deg = day.wind_heading_deg.value_or(part.wind.heading_deg),
                      .sky = air.sky(hour),
                      .falling_mm_h = air.falling_mm_h()}});
    };
    for (int row = 0; row * row_h < day_h; ++row) add(snowpack::snow_day_h + row * row_h);
    add(snowpack::snow_day_h + day_h - moment_h);
  }
  return rows;
}

std::vector<Weather::Row> Weather::rows_of(const scene::WeatherPart& part,
                                           const phenology::FilmSeason* season) {
  if (season != nullptr) return rows_of_season(part, *season);
  if (part.weather.table.empty()) return {{.moment = of_keys(part)}};
  return rows_of_table(part);
}

Weather::Weather(const scene::WeatherPart& part, const phenology::FilmSeason* season)
    : rows_(rows_of(part, season)), earlier_s_(seconds_per_hour * part.weather.earlier_h) {
  for (Row& row : rows_) {
    row.moment = with_strength(row.moment, part.strength);
    row.wind_m_s = wind_of(row.moment);
  }
  rows_[0].way_m = rows_[0].time_s * rows_[0].wind_m_s;
  rows_[0].run_m = rows_[0].time_s * rows_[0].moment.wind_speed_m_s;
  for (std::size_t i = 1; i < rows_.size(); ++i) {
    const Row& last = rows_[i - 1];
    const double seconds = rows_[i].time_s - last.time_s;
    rows_[i].way_m = last.way_m + 0.5 * seconds * (last.wind_m_s + rows_[i].wind_m_s);
    rows_[i].run_m = last.run_m + run_of(last.wind_m_s, rows_[i].wind_m_s, 1.0, seconds);
  }
}

Weather::Span Weather::span_at(double time_s) const {
  const double now_s = time_s + earlier_s_;
  const auto after = std::upper_bound(rows_.begin(), rows_.end(), now_s,
                                      [](double t, const Row& row) { return t < row.time_s; });
  if (after == rows_.begin())
    return {rows_.front(), rows_.front(), 0.0, now_s - rows_.front().time_s};
  const Row& before = *(after - 1);
  if (after == rows_.end()) return {before, before, 0.0, now_s - before.time_s};
  return {before, *after, (now_s - before.time_s) / (after->time_s - before.time_s), 0.0};
}

WeatherMoment Weather::at(double time_s) const {
  const Span span = span_at(time_s);
  const glm::dvec2 wind = glm::mix(span.before.wind_m_s, span.after.wind_m_s, span.fraction);
  const WeatherMoment& a = span.before.moment;
  const WeatherMoment& b = span.after.moment;
  const double speed = glm::length(wind);
  return {
      .temperature_c = std::lerp(a.temperature_c, b.temperature_c, span.fraction),
      .precipitation_mm_h = std::lerp(a.precipitation_mm_h, b.precipitation_mm_h, span.fraction),
      .wind_speed_m_s = speed,
      .wind_heading_deg = speed > 0.0 ? heading_deg(wind) : a.wind_heading_deg,
      .sky = between(a.sky, b.sky, span.fraction),
      .falling_mm_h = std::lerp(a.falling_mm_h, b.falling_mm_h, span.fraction)};
}

double Weather::snow_mm_h(double time_s, double height_m) const {
  return snow::snow_mm_h(at(time_s), height_m);
}

double Weather::falling_snow_mm_h(double time_s, double height_m) const {
  const WeatherMoment now = at(time_s);
  return now.falling_mm_h * snow_fraction(now, height_m);
}

double Weather::falling_rain_mm_h(double time_s, double height_m) const {
  const WeatherMoment now = at(time_s);
  return now.falling_mm_h * (1.0 - snow_fraction(now, height_m));
}

glm::dvec2 Weather::wind_way_m(double time_s) const {
  const auto [before, after, fraction, beyond_s] = span_at(time_s);
  const double seconds = fraction * (after.time_s - before.time_s);
  const glm::dvec2 mean = before.wind_m_s + 0.5 * fraction * (after.wind_m_s - before.wind_m_s);
  return before.way_m + seconds * mean + beyond_s * before.wind_m_s;
}

double Weather::wind_run_m(double time_s) const {
  const auto [before, after, fraction, beyond_s] = span_at(time_s);
  return before.run_m +
         run_of(before.wind_m_s, after.wind_m_s, fraction, after.time_s - before.time_s) +
         beyond_s * before.moment.wind_speed_m_s;
}

double Weather::heaviest_mm_h() const {
  double heaviest = 0.0;
  for (const Row& row : rows_) heaviest = std::max(heaviest, row.moment.falling_mm_h);
  return heaviest;
}

}  // namespace wold::snow
