#include "core/table.h"

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>

namespace wold {
namespace {

void check(std::span<const Column> columns) {
  for (const Column& column : columns) {
    if (column.values.size() != columns.front().values.size())
      throw std::invalid_argument(fmt::format("column \"{}\" has {} values, \"{}\" has {}",
                                              column.name, column.values.size(),
                                              columns.front().name, columns.front().values.size()));
    if (column.name.find_first_of(",\"\r\n") != std::string::npos)
      throw std::invalid_argument(fmt::format("column \"{}\" needs a simpler name", column.name));
  }
}

}  // namespace

std::string csv(std::span<const Column> columns) {
  if (columns.empty()) return "";
  check(columns);
  const auto line = [&](const auto& cell) {
    std::string text;
    for (const Column& column : columns)
      text += fmt::format("{}{}", text.empty() ? "" : ",", cell(column));
    return text + "\n";
  };
  std::string text = line([](const Column& column) { return column.name; });
  for (std::size_t row = 0; row < columns.front().values.size(); ++row)
    text += line([row](const Column& column) { return fmt::format("{:.6g}", column.values[row]); });
  return text;
}

}  // namespace wold
