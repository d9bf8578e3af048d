#include "season/film_season.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold::season {
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
  const FilmSeason season(keyed_autumn());
  ASSERT_EQ(season.days().size(), 31U);
  EXPECT_EQ(season.first_day(), 0);
  const auto mean_c = [&](int day) {
    const Day& at = season.days()[static_cast<std::size_t>(day)];
    return 0.5 * (at.tmin_c + at.tmax_c);
  };
  EXPECT_DOUBLE_EQ(mean_c(0), 10.0);
  EXPECT_DOUBLE_EQ(mean_c(10), 7.0);
  EXPECT_DOUBLE_EQ(mean_c(30), 4.0);
  EXPECT_EQ(season.days()[0].precipitation_mm, 12.0);
  EXPECT_EQ(season.days()[0].wind_speed_m_s, scene::Scene().wind.speed_m_s);
  EXPECT_DOUBLE_EQ(season.weathering()[5], 0.1);
  EXPECT_DOUBLE_EQ(season.weathering()[8], 0.22);
  EXPECT_DOUBLE_EQ(season.weathering()[30], 0.7);
  EXPECT_DOUBLE_EQ(season.cloud_cover(7.5), 0.4);
  EXPECT_DOUBLE_EQ(season.cloud_cover(-3.0), 0.2);
  EXPECT_DOUBLE_EQ(season.cloud_cover(99.0), 1.0);
}

// Without a table, too, days grow shorter in autumn, and the sun sinks (table 2.6 of FAO 56).
TEST(FilmSeason, HasTheSunOfItsDays) {
  scene::Scene scene = keyed_autumn();
  scene.sun.latitude_deg = 46.5;
  const FilmSeason season(scene);
  EXPECT_NEAR(season.days().front().day_length_h, 13.15, 0.1);
  EXPECT_NEAR(season.days().back().day_length_h, 11.5, 0.15);
  EXPECT_NEAR(season.days().front().top_sun_mj_m2, 31.0, 1.0);
  EXPECT_NEAR(season.days().back().top_sun_mj_m2, 22.8, 1.0);
}

TEST(FilmSeason, IsAFilmOfItsFrames) {
  const scene::Scene film = as_film(keyed_autumn());
  ASSERT_EQ(film.ageing.frames.size(), 61U);
  EXPECT_DOUBLE_EQ(film.ageing.frames[16], 0.22);  // the 9th of September
  EXPECT_EQ(film.weather.earlier_h, film.sun.time_h);
  scene::Scene plain;
  EXPECT_EQ(as_film(plain), plain);
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
  EXPECT_THROW(FilmSeason{scene}, InputError);  // days more than a year apart
  write_file(file, "date,tmin_c,tmax_c,precipitation_mm\n2026-08-22,2,12,3\n2026-10-05,2,12,3\n");
  const FilmSeason season(scene);
  EXPECT_EQ(season.first_day(), -10);
  EXPECT_EQ(season.days().front().precipitation_mm, 3.0);
  EXPECT_EQ(season.days().front().tmin_c, 5.0);  // 10 degrees, half the table's range below
  EXPECT_EQ(as_film(scene).weather.earlier_h, 240.0 + scene.sun.time_h);
  scene.season.last = {2026, 12, 1};
  EXPECT_THROW(FilmSeason{scene}, InputError);  // the table ends before
}

}  // namespace
}  // namespace wold::season
