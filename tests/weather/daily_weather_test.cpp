#include "weather/daily_weather.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"
#include "weather/day_length.h"

namespace wold::weather {
namespace {

using std::chrono::sys_days;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

constexpr double latitude = 47.0;

/// A file of daily weather.
class DailyWeather : public testing::Test {
 protected:
  std::vector<Day> read(const std::string& text) {
    const auto file = folder_.path() / "days.csv";
    write_file(file, text);
    return read_daily_weather(file, latitude);
  }

  /// What is wrong with it, without the folder.
  std::vector<std::string> problems(const std::string& text) {
    std::vector<std::string> messages;
    try {
      read(text);
    } catch (const InputError& error) {
      for (const Problem& problem : error.problems())
        messages.push_back(to_string(problem).substr(folder_.path().string().size() + 1));
    }
    return messages;
  }

  test::TemporaryFolder folder_{"daily_weather"};
};

TEST_F(DailyWeather, IsReadByNameAmongCommentsAndOtherColumns) {
  const std::vector<Day> days = read(
      "# measured on the moor\r\n"
      "precipitation_mm,station,date,tmax_c,tmin_c,wind_speed_m_s,cloud_cover\r\n"
      "1.5,\"a, b\",2003-12-31,4,-1,3,\r\n"
      "\r\n"
      "0,,2004-01-01,2,-3,,0.5\r\n");
  ASSERT_EQ(days.size(), 2U);
  EXPECT_EQ(days[0].date, sys_days(2003y / 12 / 31));
  EXPECT_EQ(days[0].tmin_c, -1.0);
  EXPECT_EQ(days[0].tmax_c, 4.0);
  EXPECT_EQ(days[0].precipitation_mm, 1.5);
  EXPECT_EQ(days[0].wind_speed_m_s, 3.0);
  EXPECT_EQ(days[0].cloud_cover, std::nullopt);
  EXPECT_EQ(days[1].wind_speed_m_s, std::nullopt);
  EXPECT_EQ(days[1].cloud_cover, 0.5);
  EXPECT_EQ(days[1].day_length_h, day_length_h(1, latitude));
  EXPECT_EQ(day_of_year(days[0].date), 365);
}

TEST_F(DailyWeather, HasNoGaps) {
  const std::vector<Day> days = read(
      "date,tmin_c,tmax_c,precipitation_mm\n"
      "2004-02-27,,,\n"
      "2004-02-28,0,4,1\n"
      "2004-03-01,2,8,2\n"  // the leap day is missing
      "2004-03-02,,,\n");
  ASSERT_EQ(days.size(), 5U);
  EXPECT_EQ(days[2].date, sys_days(2004y / 2 / 29));
  const std::vector<double> tmin = {0.0, 0.0, 1.0, 2.0, 2.0}, tmax = {4.0, 4.0, 6.0, 8.0, 8.0},
                            precipitation = {1.5, 1.0, 1.5, 2.0, 1.5};
  for (std::size_t i = 0; i < days.size(); ++i) {
    EXPECT_EQ(days[i].tmin_c, tmin[i]) << i;
    EXPECT_EQ(days[i].tmax_c, tmax[i]) << i;
    EXPECT_EQ(days[i].precipitation_mm, precipitation[i]) << i;
  }
}

TEST_F(DailyWeather, JoinsGapsByLines) {
  const std::vector<Day> days =
      read("date,tmin_c,tmax_c,precipitation_mm\n2004-06-01,0,10,0\n2004-06-05,8,30,0\n");
  ASSERT_EQ(days.size(), 5U);
  for (std::size_t i = 0; i < days.size(); ++i) {
    EXPECT_DOUBLE_EQ(days[i].tmin_c, 2.0 * static_cast<double>(i));
    EXPECT_DOUBLE_EQ(days[i].tmax_c, 10.0 + 5.0 * static_cast<double>(i));
  }
}

TEST_F(DailyWeather, FillsRainFromTheSameSeason) {
  std::string text = "date,tmin_c,tmax_c,precipitation_mm\n";
  for (int year = 2001; year < 2004; ++year)
    text += fmt::format("{0}-01-10,0,1,6\n{0}-07-10,0,1,{1}\n", year, year == 2002 ? "" : "2");
  const std::vector<Day> days = read(text);
  const auto on = [&](sys_days date) {
    return days[static_cast<std::size_t>((date - days[0].date).count())].precipitation_mm;
  };
  EXPECT_EQ(on(2002y / 7 / 10), 2.0);
  EXPECT_EQ(on(2002y / 12 / 30), 6.0);
  EXPECT_EQ(on(2002y / 4 / 10), (3 * 6.0 + 2 * 2.0) / 5);
}

TEST_F(DailyWeather, TellsItsLatitudeByItsDays) {
  std::string text = "date,tmin_c,tmax_c,precipitation_mm,day_length_s\n";
  for (int month = 1; month <= 12; ++month) {
    const sys_days date = 2005y / month / 21;
    // rounded as Daymet does
    const double seconds =
        std::round(day_length_h(day_of_year(date), -33.5) * 3600 / 345.6) * 345.6;
    text += "2005-" + std::string(month < 10 ? "0" : "") + std::to_string(month) + "-21,0,1,0," +
            std::to_string(seconds) + "\n";
  }
  EXPECT_NEAR(latitude_deg(read(text)), -33.5, 0.3);
}

TEST_F(DailyWeather, NamesEverythingThatIsWrong) {
  EXPECT_THAT(
      problems("# one\ndate,tmin_c,tmax_c,precipitation_mm\n"
               "2003-02-29,0,1,0\n"
               "# two\n"
               "2003-03-01,warm,1,-1\n"
               "2003-03-01,0,1,0\n"),
      ElementsAre("days.csv:3:1: date: found 2003-02-29, expected a day of the calendar as "
                  "in 2012-02-29",
                  "days.csv:5:2: tmin_c: found warm, expected a number from -90 to 60 deg C",
                  "days.csv:5:4: precipitation_mm: found -1, expected a number from 0 to "
                  "2000 mm",
                  "days.csv:6:1: date: found 2003-03-01 after 2003-03-01, expected a later "
                  "day than in the line above"));
  EXPECT_THAT(
      problems("date,tmin_c,tmax_c,precipitation_mm\n"
               "2003-03-01,5,1,\n"
               "2005-03-01,0,1,\n"),
      ElementsAre(HasSubstr("days.csv:2:2: found tmin_c 5 above tmax_c 1"),
                  HasSubstr("days.csv:3:1: found a day more than a year after"),
                  HasSubstr("days.csv:2:4: found no number in the column precipitation_mm")));
  EXPECT_THAT(problems("date,tmin,tmax_c,precipitation_mm\n2003-03-01,5,1,0\n"),
              ElementsAre("days.csv:1:1: found no column \"tmin_c\", expected the header's line to "
                          "name it; is it \"tmin\"?"));
  EXPECT_THAT(problems("# nothing\n\n"), ElementsAre(HasSubstr("found no header")));
  EXPECT_THROW(read_daily_weather("/nowhere/days.csv", latitude), FileError);
}

// Medians of 12 to 27 days each at Col de Porte, from October 2005 to September 2006, of how
// heavily the mean drop falls. As heavily as the day's mean at least.
TEST(WetHours, AreThoseOfMeasuredDays) {
  const std::pair<double, double> mm_and_mm_h[] = {
      {1.1, 0.47}, {3.2, 0.67}, {7.0, 1.47}, {14.1, 2.33}, {26.1, 3.96}};
  for (const auto& [mm, mm_h] : mm_and_mm_h)
    EXPECT_NEAR(mm / wet_hours(mm), mm_h, 0.3 * mm_h) << mm;
  for (const double mm : {0.0, 500.0, 2000.0}) EXPECT_EQ(wet_hours(mm), 24.0);
  EXPECT_GT(wet_hours(1e-6), 0.0);
}

TEST(DayLength, IsThatOfTheFireDangerRatingSystem) {
  const auto seconds = [](int day) { return 3600.0 * day_length_h(day, 40.0); };
  EXPECT_NEAR(seconds(172), 53445.4, 1.0);
  EXPECT_NEAR(seconds(266), 42794.1, 1.0);
  EXPECT_NEAR(seconds(300), 37498.6, 1.0);
  EXPECT_NEAR(seconds(355), 32954.6, 1.0);
  EXPECT_EQ(day_length_h(172, 80.0), 24.0);
  EXPECT_EQ(day_length_h(355, 80.0), 0.0);
}

// Allen and others 1998, example 8: 3 September at 20 degrees south, 32.2 MJ/m2.
TEST(ExtraterrestrialRadiation, IsThatOfFao56) {
  EXPECT_NEAR(extraterrestrial_mj_m2(246, -20.0), 32.2, 0.1);
  EXPECT_EQ(extraterrestrial_mj_m2(355, 80.0), 0.0);
}

}  // namespace
}  // namespace wold::weather
