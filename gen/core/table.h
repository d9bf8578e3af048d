#pragma once

#include <span>
#include <string>
#include <vector>

namespace wold {

/// A named column of numbers, or of words that need no quotes.
struct Column {
  std::string name;  ///< with the unit at its end, where it has one: tip_angle_deg
  std::vector<double> values;
  std::vector<std::string> words = {};  ///< in the place of values, when those are empty
};

/// The columns as comma-separated values (RFC 4180, but lines end in \n), UTF-8: a header, then a
/// row per value, six significant digits with a decimal point in every locale. Throws
/// std::invalid_argument when the columns differ in length, naming both, or a name would need
/// quotes.
std::string csv(std::span<const Column> columns);

}  // namespace wold
