#pragma once

#include "snow/size_distribution.h"

namespace wold::snow {

/// Marshall and Palmer 1948 (The distribution of raindrops with size): N0 = 8000 per m3 and mm,
/// Lambda = 4.1 R^-0.21 per mm, for a rate R of rain in mm/h; diameters are the drops' own. No
/// rate, no drops. Throws std::invalid_argument for a rate that is negative or no number.
SizeDistribution marshall_palmer(double rate_mm_h);

/// The integral of Q pi / 4 d^2 N(d) over drops larger than `diameter_mm`, for an extinction
/// efficiency Q as in size_distribution.h: Q pi N0 / (2 Lambda^3) mm2 per m3 of all of them.
double rain_extinction_above_per_m(const SizeDistribution& drops, double efficiency,
                                   double diameter_mm);
double rain_extinction_per_m(double rate_mm_h, double efficiency);

/// Terminal speed in still air at the sea: 9.65 - 10.3 exp(-0.6 d) m/s (Atlas, Srivastava and
/// Sekhon 1973, Doppler radar characteristics of precipitation at vertical incidence), what Gunn
/// and Kinzer measured in 1949 from 0.6 to 5.8 mm; 0 below 0.11 mm.
double drop_speed_m_s(double diameter_mm);

/// Smaller drops are never drawn.
inline constexpr double min_drop_mm = 0.5;

}  // namespace wold::snow
