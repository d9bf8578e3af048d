#pragma once

#include <cstddef>

#include "core/ground_map.h"
#include "core/parallel.h"
#include "core/row_parts.h"

namespace wold {

/// A map of a function's values: value(place in metres).
template <class Map, class Value>
Map filled(const GroundGrid& grid, const Value& value) {
  Map map(grid.samples, grid.square);
  parallel_for(static_cast<std::size_t>(grid.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < grid.samples; ++i) map.at(i, j) = value(map.place_m(i, j));
  });
  return map;
}

/// The map where `parts` of its rows count, a coarser one's values elsewhere.
template <class T, class Meaning>
GroundMap<T, Meaning> filled_up(const GroundMap<T, Meaning>& map, const RowParts& parts,
                                const GroundMap<T, Meaning>& coarser) {
  auto all = filled<GroundMap<T, Meaning>>(
      {map.square(), map.samples()},
      [&](const glm::dvec2& at_m) { return coarser.sample(at_m.x, at_m.y); });
  parallel_for(parts.size(), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(parts[row], [&](int i) { all.at(i, j) = map.at(i, j); });
  });
  return all;
}

}  // namespace wold
