#include "core/table.h"

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>

namespace wold {
namespace {

std::size_t rows_of(const Column& column) {
  return column.values.empty() ? column.words.size() : column.values.size();
}

std::string cell_of(const Column& column, std::size_t row) {
  return column.values.empty() ? column.words[row] : fmt::format("{:.6g}", column.values[row]);
}

void check(std::span<const Column> columns) {
  for (const Column& column : columns) {
    if (rows_of(column) != rows_of(columns.front()))
      throw std::invalid_argument(fmt::format("column \"{}\" has {} values, \"{}\" has {}",
                                              column.name, rows_of(column), columns.front().name,
                                              rows_of(columns.front())));
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
  for (std::size_t row = 0; row < rows_of(columns.front()); ++row)
    text += line([row](const Column& column) { return cell_of(column, row); });
  return text;
}

}  // namespace wold
