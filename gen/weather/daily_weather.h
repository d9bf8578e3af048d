#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace wold::weather {

/// The weather of one day.
struct Day {
  std::chrono::sys_days date;
  double tmin_c = 0.0;  ///< lowest air temperature, not above tmax_c
  double tmax_c = 0.0;
  double precipitation_mm = 0.0;  ///< of water, rain or snow
  double wet_h = 24.0;            ///< in which it falls
  double day_length_h = 12.0;     ///< from sunrise to sunset
  double top_sun_mj_m2 = 36.0;    ///< radiation on the level above the atmosphere
  std::optional<double> wind_speed_m_s;
  std::optional<double> wind_heading_deg;  ///< where it blows to, clockwise from north
  std::optional<double> cloud_cover;       ///< 0 clear to 1 overcast
  std::optional<double> visual_range_m;    ///< of the air without rain
};

/// Hours in which a day's precipitation falls, so that precipitation over hours is how heavily the
/// mean drop falls. Above 0 and at most 24; 24 on a dry day. `precipitation_mm` >= 0.
///
/// Fitted to the hourly rain and snow of 92 days, six to six, with 0.5 mm or more at Col de Porte
/// from October 2005 to September 2006 (measured by Morin and others 2012, as Essery 2015, A
/// factorial snowpack model, has them): 0.425 mm/h times (mm a day)^0.612.
double wet_hours(double precipitation_mm);

/// Day of the year, 1 to 366.
int day_of_year(std::chrono::sys_days date);

/// A file's days from the first to the last, none left out.
///
/// Comma-separated values with a header; columns by name, in any order, others are ignored: date
/// (rising, as 2012-02-29), tmin_c, tmax_c, precipitation_mm and, if known, day_length_s,
/// wind_speed_m_s, wind_heading_deg, cloud_cover, visual_range_m. Cells may be empty and days may
/// be missing: their temperatures are interpolated in time, or those of the nearest day at the
/// ends; their precipitation is the mean of the file's days at most 15 calendar days apart from
/// them in any year, or else of all its days. Day lengths and the sun's radiation are those of the
/// latitude that fits day_length_s best, or without any of `latitude_deg`.
///
/// Throws InputError with every problem found, with line and column: what read_table() finds,
/// tmin_c above tmax_c, days more than a year apart, a column without any number. Throws FileError
/// when the file cannot be read.
std::vector<Day> read_daily_weather(const std::filesystem::path& file, double latitude_deg);

/// The latitude, -90 to 90 degrees, whose days are so long.
double latitude_deg(std::span<const Day> days);

}  // namespace wold::weather
