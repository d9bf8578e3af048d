#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace wold::snow {

/// A column that a table of numbers may have.
struct TableColumn {
  std::string name;
  double lowest = 0.0;  ///< range of its numbers, ends included
  double highest = std::numeric_limits<double>::max();
  std::string unit;
  bool rises = false;     ///< every number is larger than the one above it
  bool required = false;  ///< otherwise it may be missing
};

/// The columns' numbers, in the order of `columns`, empty for those that the file does not have.
///
/// The file is comma-separated values (RFC 4180) with a header, read by GDAL; columns may come in
/// any order. Throws InputError with every problem found, each with file, line (the header's is 1;
/// an empty line is not counted) and the number and name of the column: columns that are missing,
/// unknown or twice there, numbers that are none, not finite, out of range or do not rise, a table
/// without rows. Throws FileError when the file cannot be read.
std::vector<std::vector<double>> read_table(const std::filesystem::path& file,
                                            const std::vector<TableColumn>& columns);

}  // namespace wold::snow
