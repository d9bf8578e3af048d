#include "snow/weather.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold::snow {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A scene whose weather is that table.
class WeatherTable {
 public:
  explicit WeatherTable(const std::string& text) : folder_("weather") {
    scene.weather.table = (folder_.path() / "weather.csv").string();
    write_file(scene.weather.table, text);
  }

  /// What is wrong with it, without the folder.
  std::vector<std::string> problems() const {
    std::vector<std::string> messages;
    try {
      const Weather weather(scene, nullptr);
    } catch (const InputError& error) {
      for (const Problem& problem : error.problems())
        messages.push_back(to_string(problem).substr(folder_.path().string().size() + 1));
    }
    return messages;
  }

  scene::Scene scene;

 private:
  test::TemporaryFolder folder_;
};

TEST(Weather, IsConstantWithoutATable) {
  scene::Scene scene;
  scene.weather.temperature_c = -4.0;
  scene.weather.precipitation_mm_h = 2.0;
  scene.wind.speed_m_s = 3.0;
  scene.wind.heading_deg = 90.0;
  scene.weather.earlier_h = 2.0;
  const Weather weather(scene, nullptr);
  EXPECT_EQ(weather.at(1e5).temperature_c, -4.0);
  EXPECT_EQ(weather.at(-100.0).precipitation_mm_h, 2.0);
  EXPECT_NEAR(weather.at(0.0).wind_heading_deg, 90.0, 1e-9);
  EXPECT_NEAR(weather.wind_way_m(-7200.0).x, 0.0, 1e-9);
  EXPECT_NEAR(weather.wind_way_m(10.0).x, 3.0 * 7210.0, 1e-6);
  EXPECT_NEAR(weather.wind_run_m(10.0), 3.0 * 7210.0, 1e-6);
}

TEST(Weather, StrengthIsARateOfSnowHoweverWarm) {
  scene::Scene scene;
  scene.weather.temperature_c = 5.0;
  scene.snowfall.strength = scene::SnowfallStrength::blizzard;
  const WeatherMoment now = Weather(scene, nullptr).at(0.0);
  EXPECT_EQ(now.precipitation_mm_h, 4.0);
  EXPECT_EQ(snow_fraction(now.temperature_c), 1.0);
  EXPECT_EQ(Weather(scene, nullptr).heaviest_mm_h(), 4.0);
}

TEST(Weather, TablesAreLinearBetweenRowsAndCountFromEarlier) {
  WeatherTable table(
      "precipitation_mm_h,hours,temperature_c\n"
      "0,1,0\n"
      "2,3,-4\n");
  table.scene.weather.earlier_h = 2.0;
  table.scene.wind.speed_m_s = 7.0;
  const Weather weather(table.scene, nullptr);
  EXPECT_NEAR(weather.at(0.0).temperature_c, -2.0, 1e-12);
  EXPECT_NEAR(weather.at(1800.0).precipitation_mm_h, 1.5, 1e-12);
  EXPECT_EQ(weather.at(1e6).precipitation_mm_h, 2.0);
  EXPECT_EQ(weather.at(-7200.0).temperature_c, 0.0);
  EXPECT_NEAR(weather.at(0.0).wind_speed_m_s, 7.0, 1e-12);
}

TEST(Weather, WaysAreTheIntegralsOfTheWind) {
  WeatherTable table(
      "hours,wind_speed_m_s,wind_heading_deg\n"
      "0,5,350\n0.01,5,10\n0.02,0,10\n0.03,4,180\n0.04,4,0\n");
  const Weather weather(table.scene, nullptr);
  glm::dvec2 way = weather.wind_way_m(0.0);
  double run = weather.wind_run_m(0.0);
  const double step_s = 0.01;  // the midpoint rule's error falls with its square
  for (int i = 0; i < 18000; ++i) {
    const WeatherMoment now = weather.at((i + 0.5) * step_s);
    const double heading = now.wind_heading_deg * std::numbers::pi / 180.0;
    way += step_s * now.wind_speed_m_s * glm::dvec2(std::sin(heading), std::cos(heading));
    run += step_s * now.wind_speed_m_s;
    if (i % 500 != 499) continue;
    EXPECT_NEAR(glm::distance(weather.wind_way_m((i + 1) * step_s), way), 0.0, 1e-5) << i;
    EXPECT_NEAR(weather.wind_run_m((i + 1) * step_s), run, 1e-4) << i;
  }
  // From 350 to 10 degrees through north, not through south.
  EXPECT_NEAR(std::remainder(weather.at(18.0).wind_heading_deg, 360.0), 0.0, 1e-9);
}

TEST(Weather, NamesEveryWrongNumberByLineAndColumn) {
  const WeatherTable table(
      "hours,temperature_c,precipitation_mm_h,wind_speed_m_s\n"
      "0,-2,1,3\n"
      "1,nan,-1,inf\n"
      "1,-2,snow,\n");
  EXPECT_THAT(
      table.problems(),
      ElementsAre(
          "weather.csv:3:2: temperature_c: found nan, expected a number from -60 to 50 deg C",
          "weather.csv:3:3: precipitation_mm_h: found -1, expected a number from 0 to 50 mm/h",
          "weather.csv:3:4: wind_speed_m_s: found inf, expected a number from 0 to 60 m/s",
          "weather.csv:4:1: hours: found 1 after 1, expected a larger number than in the line "
          "above",
          "weather.csv:4:3: precipitation_mm_h: found snow, expected a number from 0 to 50 mm/h",
          "weather.csv:4:4: wind_speed_m_s: found nothing, expected a number from 0 to 60 m/s"));
}

TEST(Weather, NamesWrongColumns) {
  EXPECT_THAT(
      WeatherTable("hour,temperature_c,temperature_c\n0,1,1\n").problems(),
      ElementsAre(HasSubstr("weather.csv:1:1: found a column \"hour\", expected hours, "
                            "temperature_c, precipitation_mm_h, wind_speed_m_s, "
                            "wind_heading_deg; did you mean \"hours\"?"),
                  "weather.csv:1:3: found the column \"temperature_c\" twice, expected it "
                  "once",
                  "weather.csv:1:1: found no column \"hours\", expected the header's line to "
                  "name it"));
  EXPECT_THAT(WeatherTable("hours,temperature_c\n").problems(),
              ElementsAre(HasSubstr("found no rows")));
}

TEST(Weather, SaysWhenTheTableIsNotThere) {
  scene::Scene scene;
  scene.weather.table = "/nowhere/weather.csv";
  EXPECT_THROW(Weather(scene, nullptr), FileError);
}

}  // namespace
}  // namespace wold::snow
