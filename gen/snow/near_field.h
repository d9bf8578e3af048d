#pragma once

namespace wold::snow {

/// How snow is shared between flakes that are drawn singly and a fog that stands for all others.
///
/// At a distance r the fraction k(r) = exp(-r / reach) of the flakes above a least size is drawn
/// ([He2007], figure 3). With a homogeneous fog of extinction S (1 - T / 3.912), T the optical
/// depth of all that is drawn and S that of the snow per metre, air of the length L has the optical
/// depth
///   S L (1 - T / 3.912) + T (1 - exp(-L / reach)):
/// that of the snow where 2 % are seen through it, S L = 3.912, and off by at most T before that
/// and until twice as far. T is kept below 0.05.
struct NearField {
  double number_per_m3 = 0.0;  ///< of flakes above the least size, all of them
  double reach_m = 1.0;
  double fog_extinction_per_m = 0.0;
};

/// Smaller flakes, of 0.9 mm and less, are never drawn.
inline constexpr double min_melted_mm = 0.5;

/// So that about `flakes` are drawn within the solid angle, if that is not more than T allows:
/// their number is number_per_m3 times 2 reach^3 per steradian. rate_mm_h > 0.
NearField near_field(double rate_mm_h, double solid_angle_sr, double flakes);

/// The same of drops larger than min_drop_mm; number_per_m3 is that of the heaviest rain, of
/// whose drops those that are there are drawn. heaviest_mm_h >= rate_mm_h > 0.
NearField near_rain(double rate_mm_h, double heaviest_mm_h, double solid_angle_sr, double drops);

}  // namespace wold::snow
