#pragma once

#include <cstdint>

#include "core/ground_map.h"

namespace wold::snow {

/// Where thin snow lies first on large terrains: in patches of all sizes from 100 m down, each size
/// of the same variance, drawn towards the hollows of the ground, so that snow lines are ragged
/// near and far. A keyed function of the place, the same for maps of all steps.
class SnowLine {
 public:
  /// `smallest_m`: size of the smallest patches, > 0; more than 100 m are 100 m. Hollows are those
  /// that the terrain's steps show.
  SnowLine(const Heightfield& terrain, double smallest_m, std::uint64_t seed);

  /// Where the ground is white, [0, 1], on a map of the fractions of it that are, both over the
  /// same part of the terrain: as far as its steps show patches, grey by the finer ones. Over a
  /// wide area its mean is that of the fractions; it grows wherever they do.
  FactorMap white_map(const FactorMap& fractions) const;

 private:
  double smallest_m_;
  std::uint64_t key_;
  FactorMap hollows_;  ///< snow::hollows()
};

}  // namespace wold::snow
