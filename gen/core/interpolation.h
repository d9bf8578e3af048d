#pragma once

namespace wold {

/// The bilinear value between the four corners of a cell, each named by its x and y. `u` and `v`
/// are the place's coordinates in the cell, from 0 to 1. A value may be any type that has sums and
/// multiples by a Weight.
template <class Value, class Weight>
Value bilinear(const Value& at_00, const Value& at_10, const Value& at_01, const Value& at_11,
               Weight u, Weight v) {
  constexpr Weight one{1};
  return (at_00 * (one - u) + at_10 * u) * (one - v) + (at_01 * (one - u) + at_11 * u) * v;
}

}  // namespace wold
