#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "landscape/cell_parts.h"
#include "scene/scene.h"

namespace wold::meadow {

/// The ground of a cell: a parallelogram with two sides to the north.
struct CellGround {
  glm::dvec2 middle_m{0.0};
  double side_m = 0.0;  ///< its extent to the east and to the north
  double shear = 0.0;   ///< of the other sides, to the north for each metre to the east

  /// A place given by fractions of the sides from the south-western corner, metres.
  glm::dvec2 place_m(const glm::dvec2& fraction) const {
    const glm::dvec2 from_middle_m = (fraction - 0.5) * side_m;
    return middle_m + from_middle_m + glm::dvec2(0.0, shear * from_middle_m.x);
  }
};

/// Where the cells of a meadow stand on the ground, keyed. On squares side by side the same few
/// patches make straight rows, and one sees each of their plants again and again along a row. So
/// each row of cells begins elsewhere, like bricks, and rows are wavy lines. Straight pieces of two
/// rows that bend do not fit: patches leave 0.4 % of a side free between them. At the terrain's
/// borders a row begins and ends up to half a cell inside or outside. Cells are squares where
/// patches go on in each other, those of a coat or of grass.from_texel, and where there is but one.
class CellLattice {
 public:
  static constexpr double max_shift = 0.5;  ///< of a cell along each axis, in sides of cells

  explicit CellLattice(const scene::Scene& scene);

  CellGround ground(const glm::ivec2& cell) const;

  /// How far to the east of where a row of squares would a row begins, in sides of cells.
  double row_shift(int row) const;

  /// Shifts and shears a patch that stands on its cell.
  void place_patch(landscape::CellPose& pose) const;

  /// The cell on which a place is, but for a hundredth of a side where rows bend.
  glm::ivec2 cell_at(const glm::dvec2& at_m) const;

 private:
  /// How far rows lie to the north of where straight ones would, in sides of cells.
  struct Wave {
    double height = 0.0;
    double slope = 0.0;
  };

  Wave wave(double x_m) const;

  double patch_m_;
  std::uint64_t rows_, waves_;  ///< keys
  bool are_squares_;
};

}  // namespace wold::meadow
