#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace wold::grass {

/// A file of models/: named columns of numbers, with their source in its comments.
class ModelTable {
 public:
  /// Throws FileError when the file is missing or damaged or holds anything but arrays of numbers.
  explicit ModelTable(const std::filesystem::path& file);

  /// A column by name. Throws FileError when there is none, or it has not `rows` numbers.
  const std::vector<double>& column(const std::string& name) const;
  const std::vector<double>& column(const std::string& name, std::size_t rows) const;

 private:
  std::string file_;
  std::map<std::string, std::vector<double>> columns_;
};

}  // namespace wold::grass
