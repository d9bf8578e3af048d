#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "landscape/landscape.h"
#include "passes/ground_facts.h"
#include "passes/seen_place.h"

namespace wold::passes {

/// How far grass goes from one frame to the next as it leans over in the wind.
class Sway {
 public:
  /// Nothing sways without `facts.more_lean`, which is asked here alone.
  Sway(const landscape::Landscape& landscape, const GroundFacts& facts);

  /// By how many metres what is seen moves, world space: grass in proportion to its height in its
  /// cell, as volumes are sheared; blades that bend move a little less below their tips. 0 of all
  /// else.
  glm::dvec3 of(const SeenPlace& seen) const;

 private:
  /// Of a cell.
  struct Shear {
    glm::dmat4 cell_from_world{1.0};
    glm::dvec3 per_height{0.0};  ///< metres per metre of height in the cell
  };
  template <class Cells>
  static std::vector<Shear> shears(const Cells& cells, const GroundFacts& facts);

  std::vector<Shear> cells_, blade_cells_;  ///< as the Landscape has them; none where none sways
};

}  // namespace wold::passes
