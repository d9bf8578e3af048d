#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problems.h"
#include "scene/calendar.h"
#include "scene/sun_path.h"

namespace wold::scene {
namespace {

/// Three lines, then what is given.
std::string season(const std::string& more = "") {
  return "[season]\nfirst = [2026, 9, 1]\nlast = [2026, 11, 30]\n" + more;
}
const std::string withers = "[[season_keys]]\ndate = [2026, 9, 1]\nweathering = 0.5\n";

TEST(Season, IsReadAndSpreadsItsFramesOverTheDays) {
  const Scene scene = parse_scene(season("frames = 46\n" + withers), "a.toml");
  EXPECT_TRUE(is_season(scene));
  EXPECT_EQ(time_s(scene, 1), 0.0);
  EXPECT_EQ(time_s(scene, 2), 2.0 * 86400.0);
  EXPECT_EQ(time_s(scene, 46), 90.0 * 86400.0);
  EXPECT_EQ(scene.season_keys.at(0).weathering, 0.5);
  EXPECT_EQ(scene.season_keys[0].temperature_c, std::nullopt);
  Scene film;
  film.film.frame_seconds = 4.0;
  EXPECT_FALSE(is_season(film));
  EXPECT_EQ(time_s(film, 3), 8.0);
}

TEST(Season, SaysWhatContradictsItself) {
  EXPECT_TRUE(problems_of(season(withers)).empty());
  expect_problem(season(), "a.toml:2:1: season.first: found a season in which nothing says how");
  expect_problem(
      season(withers),
      "--set season.last=[2026,9,1]: season.last: found [2026, 9, 1], expected a day after",
      {"season.last=[2026,9,1]"});
  expect_problem(
      season(withers),
      "--set season.last=[2028,9,1]: season.last: found [2028, 9, 1], expected a day after",
      {"season.last=[2028,9,1]"});
  expect_problem(season(withers),
                 "--set season.first=[2026,2,30]: season.first: found [2026, 2, 30], expected a "
                 "year, month and",
                 {"season.first=[2026,2,30]"});
  expect_problem("[season]\nfirst = [2026, 9, 1]\n" + withers,
                 "a.toml:2:1: season.last: found [], expected a year, month and day");
  expect_problem("[season]\ntable = \"days.csv\"\n",
                 "a.toml:2:1: season.table: found the days of a season, but the scene is none");
  expect_problem(withers, "a.toml:1:1: season_keys[1]: found a day of a season, but the scene");
  expect_problem(season(withers + withers),
                 "a.toml:8:1: season_keys[2].date: found [2026, 9, 1], expected a day after");
  const auto dark = problems_of(season(withers), {"sun.time=0"});
  ASSERT_EQ(dark.size(), 1u);
  expect_start(dark[0],
               "--set sun.time=0: sun.time: found 0 h of universal time, when the sun stands at -");
}

// Beyond the polar circle the sun may be seen on the first day and the last, and not between them:
// at 73 degrees north it culminates at 17 - 23.44 at the winter solstice.
TEST(Season, HasLightOnAllOfItsDays) {
  const std::vector<std::string> polar = {"season.first=[2026,10,31]", "season.last=[2027,2,12]",
                                          "sun.time=12", "sun.longitude=0"};
  const auto problems = [&](const std::string& latitude) {
    std::vector<std::string> overrides = polar;
    overrides.push_back("sun.latitude=" + latitude);
    return problems_of(season(withers), overrides);
  };
  EXPECT_TRUE(problems("70").empty());  // dusk at noon
  ASSERT_EQ(problems("73").size(), 1u);
  EXPECT_NE(problems("73")[0].find("when the sun stands at -6.4 degrees on [2026, 12, 2"),
            std::string::npos)
      << problems("73")[0];
}

// At 47 degrees north it culminates at 90 - 47 + declination: at the equinox 43 degrees, at the
// winter solstice 23.44 less, a twentieth of a degree of refraction more.
TEST(Season, SunSinksFromEquinoxToSolstice) {
  Scene scene;
  scene.season.first = {2026, 9, 23};
  scene.season.last = {2026, 12, 21};
  scene.sun.latitude_deg = 47.0;
  scene.sun.longitude_deg = 0.0;
  scene.sun.time_h = 11.9;
  EXPECT_NEAR(sun_at(scene, 0.0).elevation_deg, 43.0, 0.25);
  EXPECT_NEAR(sun_at(scene, 1.0).elevation_deg, 43.0 - 23.44 + 0.05, 0.1);
  EXPECT_NEAR(sun_at(scene, 1.0).azimuth_deg, 180.0, 2.0);
  // Evenly, without steps from day to day.
  for (double time = 0.0; time < 1.0; time += 0.01)
    EXPECT_LT(
        std::abs(sun_at(scene, time + 0.01).elevation_deg - sun_at(scene, time).elevation_deg),
        0.4);
  scene.season.first.clear();
  EXPECT_EQ(sun_at(scene, 0.3), scene.sun);
}

}  // namespace
}  // namespace wold::scene
