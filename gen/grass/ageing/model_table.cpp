#include "grass/ageing/model_table.h"

#include <fmt/format.h>

#include <optional>

#include "core/error.h"
#include "core/model_file.h"

namespace wold::grass {
namespace {

std::vector<double> numbers(const toml::node& node, const std::string& where) {
  const toml::array* array = node.as_array();
  std::vector<double> values;
  for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
    const std::optional<double> value = array->get(i)->value<double>();
    if (!value) break;
    values.push_back(*value);
  }
  if (array == nullptr || values.empty() || values.size() != array->size())
    throw FileError(where + " is not an array of numbers");
  return values;
}

}  // namespace

ModelTable::ModelTable(const std::filesystem::path& file) : file_(file.string()) {
  for (const auto& [key, node] : read_model_file(file)) {
    const std::string name(key.str());
    columns_[name] = numbers(node, fmt::format("{}: \"{}\"", file_, name));
  }
}

const std::vector<double>& ModelTable::column(const std::string& name) const {
  const auto found = columns_.find(name);
  if (found == columns_.end())
    throw FileError(fmt::format("{}: the column \"{}\" is missing", file_, name));
  return found->second;
}

const std::vector<double>& ModelTable::column(const std::string& name, std::size_t rows) const {
  const std::vector<double>& values = column(name);
  if (values.size() != rows)
    throw FileError(fmt::format("{}: \"{}\" has {} numbers, {} were expected", file_, name,
                                values.size(), rows));
  return values;
}

}  // namespace wold::grass
