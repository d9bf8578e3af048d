#include "phenology/film_season.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold::phenology {
namespace {

scene::Scene keyed_autumn() {
  scene::Scene scene;
  scene.season.first = {2026, 9, 1};
  scene.season.last = {2026, 10, 1};
  scene.season.frames = 61;
  scene.season_keys = {
      {.date = {2026, 9, 6}, .weathering = 0.1, .temperature_c = 10.0, .cloud_cover = 0.2},
      {.date = {2026, 9, 11}, .weathering = 0.3, .precipitation_mm_day = 12.0},
      {.date = {2026, 9, 16}, .weathering = 0.7, .temperature_c = 4.0, .cloud_cover = 1.0}};
  return scene;
}

// Each quantity is linear between the days that give it and held beyond; what no day gives is the
// scene's.
TEST(FilmSeason, KeysAreJoinedByLines) {
  const auto season = film_season(keyed_autumn());
  ASSERT_EQ(season->days().size(), 31U);
  EXPECT_EQ(season->first_day(), 0);
  const auto mean_c = [&](int day) {
    const weather::Day& at = season->days()[static_cast<std::size_t>(day)];
    return 0.5 * (at.tmin_c + at.tmax_c);
  };
  EXPECT_DOUBLE_EQ(mean_c(0), 10.0);
  EXPECT_DOUBLE_EQ(mean_c(10), 7.0);
  EXPECT_DOUBLE_EQ(mean_c(30), 4.0);
  EXPECT_EQ(season->days()[0].precipitation_mm, 12.0);
  EXPECT_EQ(season->days()[0].wind_speed_m_s, scene::Scene().wind.speed_m_s);
  EXPECT_DOUBLE_EQ(season->weathering()[5], 0.1);
  EXPECT_DOUBLE_EQ(season->weathering()[8], 0.22);
  EXPECT_DOUBLE_EQ(season->weathering()[30], 0.7);
  EXPECT_DOUBLE_EQ(season->cloud_cover(7.5), 0.4);
  EXPECT_DOUBLE_EQ(season->cloud_cover(-3.0), 0.2);
  EXPECT_DOUBLE_EQ(season->cloud_cover(99.0), 1.0);
}

// Without a table, too, days grow shorter in autumn, and the sun sinks (table 2.6 of FAO 56).
TEST(FilmSeason, HasTheSunOfItsDays) {
  scene::Scene scene = keyed_autumn();
  scene.sun.latitude_deg = 46.5;
  const auto season = film_season(scene);
  EXPECT_NEAR(season->days().front().day_length_h, 13.15, 0.1);
  EXPECT_NEAR(season->days().back().day_length_h, 11.5, 0.15);
  EXPECT_NEAR(season->days().front().top_sun_mj_m2, 31.0, 1.0);
  EXPECT_NEAR(season->days().back().top_sun_mj_m2, 22.8, 1.0);
}

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

/// Ten days at 2 m/s to the east, then 4 m/s to the north-west.
scene::Scene windy_autumn() {
  scene::Scene scene = keyed_autumn();
  scene.wind.speed_m_s = 2.0;
  scene.wind.heading_deg = 90.0;
  scene.season_keys = {{.date = {2026, 9, 11}, .wind_speed_m_s = 2.0, .wind_heading_deg = 90.0},
                       {.date = {2026, 9, 12}, .wind_speed_m_s = 4.0, .wind_heading_deg = 315.0}};
  return scene;
}

// A wind that turns from 90 to 315 degrees goes through north, and its week remembers both.
TEST(FilmSeason, WindTurnsAndCombsAWeekLong) {
  const auto season = film_season(windy_autumn());
  EXPECT_EQ(season->wind(3.0).speed_factor, 1.0);
  EXPECT_EQ(season->wind(3.0).turned_rad, 0.0);
  EXPECT_NEAR(season->wind(20.0).speed_factor, 2.0, 1e-12);
  EXPECT_NEAR(season->wind(20.0).turned_rad * degrees_per_radian, -135.0, 1e-9);
  EXPECT_DOUBLE_EQ(season->days()[20].wind_heading_deg.value(), 315.0);
  // On the 14th four of seven days had 2 m/s to the east, three the other.
  const WindChange week = season->week_of_wind(13.0);
  const double east = (4.0 * 2.0 - 3.0 * 4.0 * std::sqrt(0.5)) / 7.0;
  const double north = 3.0 * 4.0 * std::sqrt(0.5) / 7.0;
  EXPECT_NEAR(week.speed_factor, std::hypot(east, north) / 2.0, 1e-12);
  EXPECT_NEAR(week.turned_rad, -std::atan2(north, east), 1e-12);
}

// From 350 to 10 degrees it is 20 degrees by north, not 340 by south.
TEST(FilmSeason, WindTurnsTheShorterWay) {
  scene::Scene scene = keyed_autumn();
  scene.season_keys = {{.date = {2026, 9, 1}, .weathering = 0.0, .wind_heading_deg = 350.0},
                       {.date = {2026, 9, 11}, .wind_heading_deg = 10.0}};
  const auto season = film_season(scene);
  EXPECT_NEAR(season->days()[2].wind_heading_deg.value(), 354.0, 1e-9);
  EXPECT_NEAR(season->days()[7].wind_heading_deg.value(), 4.0, 1e-9);
}

// What falls is seen as what it is.
TEST(FilmSeason, TheAirIsTheDaysWithoutWhatFalls) {
  scene::Scene scene = keyed_autumn();
  scene.season_keys = {{.date = {2026, 9, 11},
                        .temperature_c = 8.0,
                        .precipitation_mm_day = 9.0,
                        .visual_range_m = 11.6e3}};
  EXPECT_NEAR(film_season(scene)->visual_range_m(5.0), 11.6e3, 1e-6);
  scene.season_keys[0].visual_range_m.reset();
  EXPECT_NEAR(film_season(scene)->visual_range_m(5.0), scene.sky.visual_range_m, 1e-6);
}

TEST(FilmSeason, IsAFilmOfItsFrames) {
  const scene::Scene film = as_film(keyed_autumn(), film_season(keyed_autumn()).get());
  ASSERT_EQ(film.ageing.frames.size(), 61U);
  EXPECT_DOUBLE_EQ(film.ageing.frames[16], 0.22);  // the 9th of September
  EXPECT_EQ(film.weather.earlier_h, film.sun.time_h);
  scene::Scene plain;
  EXPECT_EQ(as_film(plain, film_season(plain).get()), plain);
}

// The table's weather begins a year before the film at most; keys win over it.
TEST(FilmSeason, TableHasTheDaysBeforeTheFilm) {
  const test::TemporaryFolder folder("season");
  const auto file = folder.path() / "days.csv";
  write_file(file,
             "date,tmin_c,tmax_c,precipitation_mm\n2024-01-01,0,10,1\n2026-08-22,2,12,3\n"
             "2026-10-05,2,12,3\n");
  scene::Scene scene = keyed_autumn();
  scene.season.table = file.string();
  for (scene::SeasonKey& key : scene.season_keys) key.precipitation_mm_day.reset();
  EXPECT_THROW(film_season(scene), InputError);  // days more than a year apart
  write_file(file, "date,tmin_c,tmax_c,precipitation_mm\n2026-08-22,2,12,3\n2026-10-05,2,12,3\n");
  const auto season = film_season(scene);
  EXPECT_EQ(season->first_day(), -10);
  EXPECT_EQ(season->days().front().precipitation_mm, 3.0);
  EXPECT_EQ(season->days().front().tmin_c, 5.0);  // 10 degrees, half the table's range below
  EXPECT_EQ(as_film(scene, film_season(scene).get()).weather.earlier_h, 240.0 + scene.sun.time_h);
  scene.season.last = {2026, 12, 1};
  EXPECT_THROW(film_season(scene), InputError);  // the table ends before
}

}  // namespace
}  // namespace wold::phenology
