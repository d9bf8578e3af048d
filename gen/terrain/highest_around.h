#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"

namespace wold::terrain {

/// The highest that a heightfield can be near a place, whatever its heights are convolved with
/// between its samples: bilinear weights or those of cubic_weights(). A bound, not the height:
/// where it is below what matters, nobody needs to know the height itself. It lies above the
/// highest sample near the place by 28 % at most of how much those samples differ.
class HighestAround {
 public:
  /// Of blocks of 8 x 8 cells, which are looked through once.
  explicit HighestAround(const Heightfield& map);

  /// Metres. Places outside of the map have what its border has.
  double highest_m(const glm::dvec2& at_m) const;
  /// The same of all places.
  double highest_m() const;

 private:
  glm::dvec2 corner_m_;
  double block_m_;
  int blocks_;                     ///< along a side
  std::vector<double> highest_m_;  ///< of blocks, row by row
};

}  // namespace wold::terrain
