#include "grass/ageing_curves.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/files.h"
#include "grass/model_table.h"

namespace wold::grass {
namespace {

std::string name_of(CurveKind kind) { return kind == CurveKind::water ? "water" : "chlorophyll"; }

/// Names of the models of a kind, in alphabetical order.
std::set<std::string> known_names(const std::filesystem::path& folder, const std::string& kind) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    if (stem.starts_with(kind + "_")) names.insert(stem.substr(kind.size() + 1));
  }
  return names;
}

Curve read_curve(const std::filesystem::path& file) {
  const ModelTable table(file);
  const std::vector<double>& x = table.column("weathering");
  const std::vector<double>& y = table.column("value", x.size());
  std::vector<glm::dvec2> points;
  for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i]);
  return Curve(std::move(points));
}

}  // namespace

Curve load_curve(CurveKind kind, const scene::CurveChoice& choice) {
  if (!choice.points.empty()) return Curve(choice.points);
  const std::filesystem::path folder = shipped_file("models/ageing");
  const std::string name = name_of(kind);
  const std::set<std::string> known = known_names(folder, name);
  if (!known.contains(choice.name))
    throw InputError(fmt::format("no {} curve is called \"{}\"; there are {}", name, choice.name,
                                 fmt::join(known, ", ")));
  return read_curve(folder / fmt::format("{}_{}.toml", name, choice.name));
}

}  // namespace wold::grass
