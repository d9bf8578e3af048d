#include "grass/ageing/ageing_curves.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/files.h"
#include "grass/ageing/model_table.h"

namespace wold::grass {
namespace {

std::string name_of(CurveKind kind) {
  switch (kind) {
    case CurveKind::water:
      return "water";
    case CurveKind::chlorophyll:
      return "chlorophyll";
    case CurveKind::rate:
      return "rate";
  }
  return {};
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

std::set<std::string> curve_names(CurveKind kind) {
  const std::string prefix = name_of(kind) + "_";
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(shipped_file("models/ageing"))) {
    const std::string stem = entry.path().stem().string();
    if (stem.starts_with(prefix)) names.insert(stem.substr(prefix.size()));
  }
  return names;
}

Curve load_curve(CurveKind kind, const scene::CurveChoice& choice) {
  if (!choice.points.empty()) return Curve(choice.points);
  const std::string name = name_of(kind);
  const std::set<std::string> known = curve_names(kind);
  if (!known.contains(choice.name))
    throw InputError(fmt::format("no {} curve is called \"{}\"; there are {}", name, choice.name,
                                 fmt::join(known, ", ")));
  return read_curve(shipped_file(fmt::format("models/ageing/{}_{}.toml", name, choice.name)));
}

}  // namespace wold::grass
