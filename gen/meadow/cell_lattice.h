#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "landscape/cell_parts.h"
#include "scene/scene.h"

namespace wold::meadow {

/// Where the cells of a meadow stand on the ground, keyed. On squares side by side the same few
/// patches make straight rows, and one sees each of their plants again and again along a row. So
/// each row of cells begins elsewhere, like bricks, and rows are wavy lines: in place of squares
/// cells are parallelograms with two sides to the north, which cover the ground all the same. The
/// cells of a coat are squares, since its patches go on in each other.
class CellLattice {
 public:
  static constexpr double max_shift = 0.5;  ///< of a cell along each axis, in sides of cells

  explicit CellLattice(const scene::Scene& scene);

  /// Shifts and shears a patch to its cell.
  void lay(landscape::CellPose& pose) const;

  glm::dvec2 middle_m(const glm::ivec2& cell) const { return place_m(cell, glm::dvec2(0.5)); }

  /// A place on a cell, given as fractions of its sides from its south-western corner, metres.
  glm::dvec2 place_m(const glm::ivec2& cell, const glm::dvec2& fraction) const;

  /// The cell on which a place is, or where rows bend a millimetre or two from it.
  glm::ivec2 cell_at(const glm::dvec2& at_m) const;

 private:
  /// How far rows lie to the north of where straight ones would, in sides of cells.
  struct Wave {
    double height = 0.0;
    double slope = 0.0;
  };

  double row_begins_m(int row) const;
  Wave wave(double x_m) const;
  /// Of a cell's middle, from where it would be on squares.
  glm::dvec2 shift_m(const glm::ivec2& cell) const;
  double shear(const glm::ivec2& cell) const;

  double patch_m_;
  std::uint64_t rows_, waves_;  ///< keys
  bool are_squares_;
};

}  // namespace wold::meadow
