#pragma once

namespace wold::weather {

/// The sun's declination in radians on a day of the year, 1 to 366; within 0.01.
double declination_rad(int day_of_year);

/// Hours from sunrise to sunset of the sun's centre over a level horizon without refraction, 0 to
/// 24. `latitude_deg` from -90 to 90, positive north. Source: Jolly, Nemani and Running 2005, A
/// generalized, bioclimatic index to predict foliar phenology (the form of the US fire danger
/// rating system of 2016).
double day_length_h(int day_of_year, double latitude_deg);

/// Radiation of the sun on a horizontal plane above the atmosphere over a day, MJ/m2. Source: Allen
/// and others 1998, Crop evapotranspiration (FAO 56), equation 21.
double extraterrestrial_mj_m2(int day_of_year, double latitude_deg);

}  // namespace wold::weather
