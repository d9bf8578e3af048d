#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace wold::weather {

/// A column that a table of numbers may have.
struct TableColumn {
  std::string name;
  double lowest = 0.0;  ///< range of its numbers, ends included
  double highest = std::numeric_limits<double>::max();
  std::string unit = "";
  bool rises = false;         ///< every number is larger than the one above it
  bool required = false;      ///< otherwise it may be missing
  bool may_be_empty = false;  ///< single cells may be: NaN
  bool is_date = false;       ///< of days, as 2012-02-29: the number of days since 1970-01-01
};

/// What becomes of columns that nobody asked for.
enum class OtherColumns { refused, ignored };

/// Numbers by columns, in the order they were asked for, empty for those that the file does not
/// have, and where they stand in the file, counted from 1.
struct NumberTable {
  std::vector<std::vector<double>> columns;
  std::vector<int> places;  ///< of the columns among all of the file's
  std::vector<int> lines;   ///< of the rows
};

/// The file is comma-separated values (RFC 4180) with a header, read by GDAL; columns may come in
/// any order, empty lines and lines that begin with # are passed over. Throws InputError with every
/// problem found, each with file, line and the number and name of the column: columns that are
/// missing, unknown or twice there, numbers that are none, not finite, out of range or do not rise,
/// a table without rows. Throws FileError when the file cannot be read.
NumberTable read_table(const std::filesystem::path& file, const std::vector<TableColumn>& columns,
                       OtherColumns other = OtherColumns::refused);

}  // namespace wold::weather
