#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"

namespace wold::passes {

/// Finds where rays meet the ground as renderers show it: each square between four heights is two
/// triangles, parted from its south-western corner to its north-eastern. It misses none, however
/// narrow: a tree of lowest and highest heights says where a ray has nothing to meet ([Tevs2008]).
class GroundCast {
 public:
  /// `terrain` has to outlive it.
  explicit GroundCast(const Heightfield& terrain);

  /// Distance in metres along a unit direction to the ground, seen from above or from below;
  /// infinite where the ray meets none.
  double distance_m(const glm::dvec3& eye_m, const glm::dvec3& direction) const;

  /// Unit normal of the triangle at a place, upwards; beyond the terrain that of its border.
  glm::dvec3 normal(const glm::dvec2& at_m) const;

 private:
  struct Heights {
    float low;
    float high;
  };
  /// Of squares of 2^k cells a side, row by row.
  struct Level {
    int columns;
    std::vector<Heights> squares;
  };
  struct Ray;

  Level finest() const;
  static Level coarser(const Level& finer);
  bool meets(Ray& ray, std::size_t level, const glm::ivec2& square, double from_m,
             double to_m) const;
  bool meets_cell(Ray& ray, const glm::ivec2& cell, double from_m, double to_m) const;
  /// A height of the cell's plane on one side of its diagonal: at a place in cells.
  double plane_m(const glm::ivec2& cell, bool is_south_eastern, const glm::dvec2& at) const;

  const Heightfield& terrain_;
  int cells_;                  ///< along a side
  std::vector<Level> levels_;  ///< fine to coarse, up to a single square
};

}  // namespace wold::passes
