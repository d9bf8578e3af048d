#pragma once

namespace wold::snow {

/// How many flakes of which size are in the air: N(d) = N0 exp(-Lambda d) for melted diameters d,
/// the diameters of the drops that flakes would melt to. The air holds N(d) dd flakes per m3.
struct SizeDistribution {
  double n0_per_m3_mm = 0.0;
  double lambda_per_mm = 1.0;

  double number_per_m3() const { return n0_per_m3_mm / lambda_per_mm; }
  /// Of those whose melted diameter is larger.
  double number_above_per_m3(double melted_mm) const;
  /// pi rho N0 / Lambda^4, the integral of the drops' masses.
  double water_g_per_m3() const;
  /// The integral of Q pi / 4 D^2 N(d) with the flakes' diameters D of flake_diameter_mm():
  /// 3 pi N0 / (0.17 Lambda^4) mm2 per m3 for an extinction efficiency Q of 2.
  double extinction_per_m(double efficiency) const;
  /// The part of it that is due to those whose melted diameter is larger.
  double extinction_above_per_m(double efficiency, double melted_mm) const;
};

/// Gunn and Marshall 1958 (The distribution with size of aggregate snowflakes): N0 = 3800 R^-0.87
/// per m3 and mm, Lambda = 2.55 R^-0.48 per mm, for a rate R of water in mm/h. No rate, no flakes.
/// Throws std::invalid_argument for a rate that is negative or no number.
SizeDistribution gunn_marshall(double rate_mm_h);

/// A flake's diameter from its melted one: snow of density 0.17 / D g/cm3 (Holroyd 1971), which
/// gives D = sqrt(d^3 / 0.17) mm. It is that of the disc which dims as much as the flake does; a
/// crystal with gaps spans more.
double flake_diameter_mm(double melted_mm);

/// By geometry alone a flake dims what lies behind its own cross-section: efficiency 1. As much
/// light again is diffracted (efficiency 2), but by less than a tenth of a degree: a picture cannot
/// tell it from light that went straight on. What was measured by transmission, 2.53 per km at
/// 1 mm/h (Warner and Gunn 1969), is 2.49 per km by this.
inline constexpr double seen_efficiency = 1.0;
inline constexpr double full_efficiency = 2.0;

/// Distance at which black things keep 2 % of their contrast (Koschmieder): 3.912 / extinction.
double visibility_m(double extinction_per_m);

}  // namespace wold::snow
