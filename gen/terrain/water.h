#pragma once

#include <cstdint>
#include <vector>

#include "core/ground_map.h"
#include "core/noise.h"

namespace wold::terrain {

/// Lakes on and around a scene's square, as a map of cells. Cells of a river are lakes, each for
/// itself.
struct Lakes {
  GroundMap<int> number;         ///< by place: index into `levels_m`; -1 is land
  std::vector<double> levels_m;  ///< over the scene's zero

  int count() const { return static_cast<int>(levels_m.size()); }
};

/// The same on a map with steps of so much or less, as far as 4097 samples along a side allow.
Lakes finer(const Lakes& lakes, double step_m);

/// The first ones, and where these have none the others; by the finer steps of both, on the square
/// of the first.
Lakes joined(const Lakes& first, const Lakes& others);

/// The water of lakes: where it is, as finely as it is asked for, and how high it stands. Shores
/// run where cells end, but round and with bays of all sizes below a cell.
class Water {
 public:
  /// At least one lake.
  Water(Lakes lakes, std::uint64_t seed);

  /// Share of a piece of ground `step_m` wide about a place that is water, in [0, 1].
  double share(const glm::dvec2& at_m, double step_m) const;

  /// Height of the water at a place and near its shore; elsewhere that of no lake in particular.
  double level_m(const glm::dvec2& at_m) const;

  /// Makes the ground level where water is, and lets the land within a cell of it come down or up
  /// to it.
  void settle(Heightfield& heights_m) const;

 private:
  double beyond_shore(const glm::dvec2& at_m) const;

  FactorMap wet_;      ///< 1 in lakes, 0 on land, smooth in between
  FactorMap level_m_;  ///< of lakes and some steps around them
  Fbm bays_;
};

}  // namespace wold::terrain
