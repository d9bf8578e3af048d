#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/ground_map.h"
#include "core/row_parts.h"

namespace wold {

/// What counts of a coarser grid's rows where parts of a finer one count: all samples that lie less
/// than `steps` of the coarser grid from those along both axes. Both cover the same square.
inline RowParts coarser_parts(const GroundGrid& fine, const RowParts& parts,
                              const GroundGrid& coarse, int steps) {
  const double scale = fine.step_m() / coarse.step_m();
  const auto first = [&](int i) { return std::max(static_cast<int>(i * scale) - steps + 1, 0); };
  const auto end = [&](int i) {
    return std::min(static_cast<int>(std::ceil(i * scale)) + steps, coarse.samples);
  };
  const auto side = static_cast<std::size_t>(coarse.samples);
  std::vector<char> counts(side * side);
  for (std::size_t row = 0; row < parts.size(); ++row)
    for (const Run& run : parts[row])
      for (int j = first(static_cast<int>(row)); j < end(static_cast<int>(row)); ++j) {
        const auto begin = counts.begin() + static_cast<std::ptrdiff_t>(side) * j;
        std::fill(begin + first(run.begin), begin + end(run.end - 1), 1);
      }
  RowParts found(side);
  for (std::size_t row = 0; row < side; ++row)
    for (int i = 0; i < coarse.samples; ++i)
      if (counts[row * side + static_cast<std::size_t>(i)] != 0) add_sample(i, found[row]);
  return found;
}

/// The sample of a finer grid next to sample `i` of a coarser one on the same square, along an
/// axis.
inline int nearest_sample(int i, int coarse_samples, int fine_samples) {
  return static_cast<int>(std::lround(i * (fine_samples - 1.0) / (coarse_samples - 1.0)));
}

/// The samples of a grid next to those of a coarser one on the same square.
inline RowParts lattice(const GroundGrid& fine, const GroundGrid& coarse) {
  RowPart row;
  for (int i = 0; i < coarse.samples; ++i) {
    const int at = nearest_sample(i, coarse.samples, fine.samples);
    row.push_back({at, at + 1});
  }
  RowParts parts(static_cast<std::size_t>(fine.samples));
  for (const Run& run : row) parts[static_cast<std::size_t>(run.begin)] = row;
  return parts;
}

/// A map with what one has at the lattice() of a coarser grid.
template <class T, class Meaning>
GroundMap<T, Meaning> on_lattice(const GroundMap<T, Meaning>& fine, const GroundGrid& coarse) {
  GroundMap<T, Meaning> map(coarse.samples, coarse.square);
  const auto at = [&](int i) { return nearest_sample(i, coarse.samples, fine.samples()); };
  for (int j = 0; j < coarse.samples; ++j)
    for (int i = 0; i < coarse.samples; ++i) map.at(i, j) = fine.at(at(i), at(j));
  return map;
}

}  // namespace wold
