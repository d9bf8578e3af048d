#pragma once

#include <cstdint>

#include "core/ground_map.h"

namespace wold::snow {

/// Fraction of the ground that snow of this much water hides: tanh(h / 0.025 m), where h is its
/// depth at 100 kg/m3 (Niu and Yang 2007, An observation-based formulation of snow cover fraction:
/// 2.5 times the ground's roughness length, here 0.01 m of litter and short grass). Its depth as
/// fresh snow, since snow that settles uncovers nothing: the fraction grows while it snows.
double cover_fraction(double water_mm);

/// White of a place of rank n in (0, 1) where a fraction of the ground is: a ramp of width `ramp` >
/// 0 in rank, placed so that the mean over evenly spread ranks is the fraction: clamp((t - n) /
/// ramp + 1/2) at the threshold t that threshold() gives.
double white(double rank, double threshold, double ramp);
double threshold(double fraction, double ramp);

/// Where thin snow lies first: noise with patches of a given size, and finer ones down to the
/// map's steps, drawn towards the hollows of the ground, as evenly spread ranks.
class WhitePatches {
 public:
  /// `samples` >= 2 along a side of the map over the terrain's square.
  WhitePatches(const Heightfield& terrain, int samples, double feature_m, std::uint64_t seed);
  /// On a part of the square; ranks are even there.
  WhitePatches(const Heightfield& terrain, const GroundGrid& grid, double feature_m,
               std::uint64_t seed);

  /// Where the ground is white, [0, 1], with soft edges about a step wide. Its mean is that of
  /// `fractions`, a map over the same square; it grows wherever they do. Where a step of the map is
  /// longer than a patch, what it shows is nearly the fraction.
  FactorMap white_map(const FactorMap& fractions) const;

  int samples() const { return ranks_.samples(); }

 private:
  FactorMap ranks_;
  double ramp_ = 1.0;
};

}  // namespace wold::snow
