#pragma once

#include <cstddef>
#include <vector>

namespace wold {

/// The samples of a map's row that count, from the west: from `begin` up to but without `end`.
struct RowPart {
  int begin = 0;
  int end = 0;
};

/// One part for each row of a map, from the south.
using RowParts = std::vector<RowPart>;

/// All of a map with so many samples along a side.
inline RowParts whole_rows(int samples) {
  return RowParts(static_cast<std::size_t>(samples), RowPart{0, samples});
}

}  // namespace wold
