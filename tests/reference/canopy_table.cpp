#include "reference/canopy_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/error.h"

namespace wold::test {

glm::dvec3 CanopyView::towards_eye() const {
  const double view = glm::radians(view_deg);
  return plane == "principal" ? glm::dvec3(0.0, std::sin(view), std::cos(view))
                              : glm::dvec3(std::sin(view), 0.0, std::cos(view));
}

CanopyTable read_canopy_table(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  CanopyTable table;
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream cells(line);
    CanopyView row;
    cells >> row.sun_deg >> row.weathering >> row.plane >> row.view_deg >> row.radiance.r >>
        row.radiance.g >> row.radiance.b;
    if (!cells) throw FileError(fmt::format("{}: found \"{}\"", path.string(), line));
    table[{row.sun_deg, row.weathering}].push_back(row);
  }
  if (table.empty()) throw FileError(fmt::format("{}: found no rows", path.string()));
  return table;
}

double quantile(std::vector<double> values, double fraction) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1))];
}

}  // namespace wold::test
