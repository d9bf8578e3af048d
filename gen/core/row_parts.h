#pragma once

#include <cstddef>
#include <vector>

namespace wold {

/// Samples of a map's row next to each other: from `begin` up to but without `end`.
struct Run {
  int begin = 0;
  int end = 0;
};

/// The samples of a map's row that count, from the west.
using RowPart = std::vector<Run>;

/// One part for each row of a map, from the south.
using RowParts = std::vector<RowPart>;

/// All of a map with so many samples along a side.
inline RowParts whole_rows(int samples) {
  return RowParts(static_cast<std::size_t>(samples), RowPart{{0, samples}});
}

/// Adds a sample to the part of its row: one east of all that count.
inline void add_sample(int i, RowPart& part) {
  if (part.empty() || part.back().end < i) part.push_back({i, i});
  part.back().end = i + 1;
}

/// visit(i) of each sample of a row that counts.
template <class Visit>
void visit_row(const RowPart& part, const Visit& visit) {
  for (const Run& run : part)
    for (int i = run.begin; i < run.end; ++i) visit(i);
}

}  // namespace wold
