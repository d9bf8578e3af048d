#include "scene/sun_position.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace wold::scene {
namespace {

using std::chrono::December;
using std::chrono::June;
using std::chrono::March;
using std::chrono::October;
using std::chrono::September;
using Date = std::chrono::year_month_day;

constexpr double minute_h = 1.0 / 60.0;

/// At every minute of a day.
std::vector<SunPosition> day_of(const Date& date, double latitude_deg, double longitude_deg) {
  std::vector<SunPosition> day;
  for (int minute = 0; minute <= 24 * 60; ++minute)
    day.push_back(sun_position(date, minute * minute_h, latitude_deg, longitude_deg));
  return day;
}

bool is_lower(const SunPosition& a, const SunPosition& b) {
  return a.elevation_deg < b.elevation_deg;
}

SunPosition highest(const std::vector<SunPosition>& day) {
  return *std::max_element(day.begin(), day.end(), is_lower);
}

double lowest_deg(const std::vector<SunPosition>& day) {
  return std::min_element(day.begin(), day.end(), is_lower)->elevation_deg;
}

/// By Bennett 1982 (Meeus 16.3), from the elevation as seen: not the formula of the module, which
/// it meets within 0.1 minutes of arc.
double bennett_deg(double seen_deg) {
  return 1.0 / std::tan((seen_deg + 7.31 / (seen_deg + 4.4)) * std::numbers::pi / 180.0) / 60.0;
}

// Reda and Andreas 2004, Solar Position Algorithm, appendix A.5: 12:30:30 seven hours west, at
// 820 hPa, whose refraction is 0.004 degrees less than sea level's.
TEST(SunPosition, IsThatOfNrelsWorkedExample) {
  const double hours_utc = 19.0 + 30.5 / 60.0;
  const SunPosition sun = sun_position(October / 17 / 2003, hours_utc, 39.742476, -105.1786);
  EXPECT_NEAR(sun.elevation_deg, 90.0 - 50.11162, 0.01);
  EXPECT_NEAR(sun.azimuth_deg, 194.34024, 0.005);
}

// Meeus, example 25.a: declination -7.78507 degrees. From the south pole the sun stands at the
// declination's height all day.
TEST(SunPosition, HasMeeusDeclination) {
  const double seen_deg = sun_position(October / 13 / 1992, 0.0, -90.0, 0.0).elevation_deg;
  EXPECT_NEAR(seen_deg - bennett_deg(seen_deg), 7.78507, 0.1 / 60.0);
}

// Meeus, example 25.a: right ascension 198.38083 degrees. From the south pole the sun's azimuth on
// the prime meridian is right ascension less Greenwich sidereal time: the mean one (Meeus 12.4),
// and the nutation's share 15.908" cos(23.44) from examples 25.b and 28.a.
TEST(SunPosition, HasMeeusRightAscension) {
  const double days = 2448908.5 - 2451545.0;
  const double sidereal_deg = 280.46061837 + 360.98564736629 * days + 15.908 / 3600.0 * 0.91747;
  const SunPosition sun = sun_position(October / 13 / 1992, 0.0, -90.0, 0.0);
  EXPECT_NEAR(std::remainder(sun.azimuth_deg + sidereal_deg - 198.38083, 360.0), 0.0, 1e-3);
}

// Meeus, example 28.a: the equation of time is 3.427351 degrees by the full theory, whose right
// ascension is 0.0027 degrees less than example 25.a's. At midnight, Greenwich mean time, the sun
// is so much past its lowest point.
TEST(SunPosition, HasMeeusEquationOfTime) {
  const SunPosition sun = sun_position(October / 13 / 1992, 0.0, -90.0, 0.0);
  EXPECT_NEAR(180.0 - sun.azimuth_deg, 3.427351, 0.003);
}

struct Equinox {
  Date date;
  double hours_utc;
};

// As almanacs give them, to the minute; a minute is 0.0003 degrees of declination.
constexpr Equinox equinoxes[] = {{March / 20 / 2000, 7.0 + 35.0 / 60.0},
                                 {March / 20 / 2024, 3.0 + 6.0 / 60.0},
                                 {September / 22 / 2024, 12.0 + 44.0 / 60.0}};

TEST(SunPosition, IsOverTheEquatorAtTheEquinoxes) {
  for (const Equinox& equinox : equinoxes) {
    const double north = sun_position(equinox.date, equinox.hours_utc, 90.0, 0.0).elevation_deg;
    const double south = sun_position(equinox.date, equinox.hours_utc, -90.0, 0.0).elevation_deg;
    EXPECT_NEAR(north, south, 0.006);
    EXPECT_NEAR(north, 29.0 / 60.0, 0.006);  // refraction of what would be on the horizon
    EXPECT_GT(highest(day_of(equinox.date, 0.0, 0.0)).elevation_deg, 89.4);
  }
}

// Meeus, example 27.a: the solstice of 1962 is on June 21 at 21:24:42; the tropic is then at the
// obliquity, 23.444 degrees, and the sun moves a quarter of a degree a minute.
TEST(SunPosition, IsOverTheTropicsAtTheSolstices) {
  const Date june = June / 21 / 1962;
  EXPECT_GT(highest(day_of(june, 23.444, -140.0)).elevation_deg, 89.85);
  EXPECT_NEAR(highest(day_of(june, 33.444, -140.0)).elevation_deg, 80.0, 0.01);
  EXPECT_NEAR(highest(day_of(December / 21 / 2024, -33.438, 20.0)).elevation_deg, 80.0, 0.01);
}

TEST(SunPosition, StandsTowardsTheEquatorAtNoon) {
  for (const Date date : {Date(March / 1 / 1950), Date(June / 21 / 2000), Date(October / 9 / 2050)})
    for (const double longitude_deg : {-60.0, 0.0, 75.0}) {
      EXPECT_NEAR(highest(day_of(date, 50.0, longitude_deg)).azimuth_deg, 180.0, 0.5);
      const double southern_deg = highest(day_of(date, -50.0, longitude_deg)).azimuth_deg;
      EXPECT_NEAR(std::remainder(southern_deg, 360.0), 0.0, 0.5);
    }
}

TEST(SunPosition, RisesInTheEast) {
  const SunPosition morning = sun_position(March / 20 / 2024, 6.5, 45.0, 0.0);
  const SunPosition evening = sun_position(March / 20 / 2024, 17.5, 45.0, 0.0);
  EXPECT_NEAR(morning.azimuth_deg, 90.0, 10.0);
  EXPECT_NEAR(evening.azimuth_deg, 270.0, 10.0);
}

TEST(SunPosition, NeitherSetsNorRisesBeyondThePolarCircles) {
  const Date june = June / 21 / 2024;
  const Date december = December / 21 / 2024;
  EXPECT_GT(lowest_deg(day_of(june, 70.0, 25.0)), 0.0);
  EXPECT_GT(lowest_deg(day_of(december, -70.0, 25.0)), 0.0);
  EXPECT_LT(highest(day_of(december, 70.0, 25.0)).elevation_deg, 0.0);
  EXPECT_LT(highest(day_of(june, -70.0, 25.0)).elevation_deg, 0.0);
  EXPECT_LT(lowest_deg(day_of(june, 60.0, 25.0)), 0.0);
  EXPECT_GT(highest(day_of(december, 60.0, 25.0)).elevation_deg, 0.0);
}

/// When the sun is in the south, in the northern hemisphere, by halving.
double solar_noon_h(const Date& date, double latitude_deg, double longitude_deg) {
  double before_h = 6.0;
  double after_h = 18.0;
  while (after_h - before_h > 1e-9) {
    const double middle_h = (before_h + after_h) / 2.0;
    const SunPosition sun = sun_position(date, middle_h, latitude_deg, longitude_deg);
    (sun.azimuth_deg < 180.0 ? before_h : after_h) = middle_h;
  }
  return before_h;
}

// At a solstice, when the declination stands still.
TEST(SunPosition, IsSymmetricAboutSolarNoon) {
  const Date june = June / 21 / 2024;
  const double noon_h = solar_noon_h(june, 50.0, 15.0);
  for (double apart_h = 0.5; apart_h < 12.0; apart_h += 0.5) {
    const SunPosition before = sun_position(june, noon_h - apart_h, 50.0, 15.0);
    const SunPosition after = sun_position(june, noon_h + apart_h, 50.0, 15.0);
    EXPECT_NEAR(before.elevation_deg, after.elevation_deg, 0.03);
    EXPECT_NEAR(before.azimuth_deg + after.azimuth_deg, 360.0, 0.1);
  }
}

// The air lifts the setting sun by 34.5 minutes of arc, 2.3 minutes of time at the equator.
TEST(SunPosition, IsUpForLongerThanHalfADayAtTheEquator) {
  int up = 0;
  for (const SunPosition& sun : day_of(March / 20 / 2024, 0.0, 0.0)) up += sun.elevation_deg > 0.0;
  EXPECT_NEAR(up, 12 * 60 + 4.6, 1.1);
}

TEST(SunPosition, MovesWithoutJumps) {
  const std::vector<SunPosition> day = day_of(March / 20 / 2024, 0.0, 0.0);
  for (std::size_t k = 1; k < day.size(); ++k) {
    EXPECT_NEAR(day[k].elevation_deg, day[k - 1].elevation_deg, 0.51);
    EXPECT_LE(std::abs(day[k].elevation_deg), 90.0);
  }
}

TEST(SunPosition, IsTheSameAtMidnightByEitherDate) {
  const SunPosition end = sun_position(December / 31 / 1999, 24.0, 51.5, -170.0);
  const SunPosition start = sun_position(std::chrono::January / 1 / 2000, 0.0, 51.5, 190.0);
  EXPECT_NEAR(end.elevation_deg, start.elevation_deg, 1e-9);
  EXPECT_NEAR(end.azimuth_deg, start.azimuth_deg, 1e-9);
}

TEST(SunPosition, HasAzimuthsOfOneTurn) {
  for (const double latitude_deg : {-90.0, -30.0, 0.0, 23.4, 66.0, 90.0})
    for (const SunPosition& sun : day_of(September / 1 / 2026, latitude_deg, 170.0)) {
      EXPECT_GE(sun.azimuth_deg, 0.0);
      EXPECT_LT(sun.azimuth_deg, 360.0);
    }
}

}  // namespace
}  // namespace wold::scene
