#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "landscape/footprint.h"

namespace wold::expectation {

/// Which cells, or parts of them, stand where on the ground: of landscape::Cell or BladeCell.
template <class Instance>
class CellFinder {
 public:
  /// `side_m`: of a patch, above 0.
  CellFinder(const std::vector<Instance>& cells, double side_m) : side_m_(side_m) {
    footprints_.reserve(cells.size());
    places_.reserve(squares_of_cell * cells.size());
    for (const Instance& cell : cells) {
      const auto number = static_cast<int>(footprints_.size());
      footprints_.emplace_back(cell.world_from_cell, cell.part, side_m);
      footprints_.back().each_square(side_m, [&](const glm::ivec2& square) {
        places_.push_back({{square.x, square.y}, number});
      });
    }
    std::ranges::stable_sort(places_, {}, &Place::square);
  }

  /// visit(its number among the cells) for each that stands at a place in metres: none, one, or
  /// shrubs and the grass around them.
  template <class Visit>
  void each_at(const glm::dvec2& at_m, const Visit& visit) const {
    const Square square = square_of(at_m);
    for (auto place = std::ranges::lower_bound(places_, square, {}, &Place::square);
         place != places_.end() && place->square == square; ++place)
      if (footprints_[static_cast<std::size_t>(place->cell)].contains(at_m)) visit(place->cell);
  }

 private:
  using Square = std::pair<int, int>;  ///< as large as a patch
  struct Place {
    Square square;
    int cell;
  };
  static constexpr std::size_t squares_of_cell = 5;  ///< that it reaches into, hardly more

  Square square_of(const glm::dvec2& at_m) const {
    return {static_cast<int>(std::floor(at_m.x / side_m_)),
            static_cast<int>(std::floor(at_m.y / side_m_))};
  }

  double side_m_;
  std::vector<landscape::Footprint> footprints_;  ///< by cell
  std::vector<Place> places_;                     ///< each cell in each square it reaches into
};

}  // namespace wold::expectation
