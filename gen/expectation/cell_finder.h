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
    places_.reserve(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Instance& cell = cells[i];
      add({{}, {cell.world_from_cell, cell.part, side_m}, static_cast<int>(i)});
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
      if (place->footprint.contains(at_m)) visit(place->cell);
  }

 private:
  using Square = std::pair<int, int>;  ///< as large as a patch
  struct Place {
    Square square;
    landscape::Footprint footprint;
    int cell;
  };

  Square square_of(const glm::dvec2& at_m) const {
    return {static_cast<int>(std::floor(at_m.x / side_m_)),
            static_cast<int>(std::floor(at_m.y / side_m_))};
  }

  /// To each square that it reaches into.
  void add(Place place) {
    place.footprint.each_square(side_m_, [&](const glm::ivec2& square) {
      place.square = {square.x, square.y};
      places_.push_back(place);
    });
  }

  double side_m_;
  std::vector<Place> places_;
};

}  // namespace wold::expectation
