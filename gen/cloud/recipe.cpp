#include "cloud/recipe.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"
#include "core/model_file.h"

namespace wold::cloud {
namespace {

/// A recipe's file; every number asked for has to be there.
class RecipeFile {
 public:
  explicit RecipeFile(scene::CloudKind kind)
      : file_(shipped_file(fmt::format("models/cloud/{}.toml", scene::word_of(kind))).string()),
        root_(read_model_file(file_)) {}

  double number(const char* path) const {
    const auto value = root_.at_path(path).value<double>();
    if (!value) throw missing(path, "a number");
    return *value;
  }

  glm::ivec2 pair(const std::string& path) const {
    const auto x = root_.at_path(path + "[0]").value<int>();
    const auto y = root_.at_path(path + "[1]").value<int>();
    if (!x || !y || *x < 1 || *y < 1) throw missing(path, "two whole numbers from 1");
    return {*x, *y};
  }

  Octaves octaves(const std::string& table) const {
    if (!root_.contains(table)) return {};
    return {number((table + ".weight").c_str()), pair(table + ".period"),
            static_cast<int>(number((table + ".octaves").c_str())),
            number((table + ".gain").c_str())};
  }

  Thermals thermals() const {
    if (!root_.contains("thermals")) return {};
    return {number("thermals.weight"), pair("thermals.period"), number("thermals.spread")};
  }

  Trails trails() const {
    if (!root_.contains("trails")) return {};
    return {number("trails.length"), number("trails.bend"), number("trails.contrast")};
  }

  Patches patches() const {
    if (!root_.contains("patches")) return {};
    return {number("patches.weight"), number("patches.cells")};
  }

  std::vector<glm::dvec2> points(const char* name) const {
    std::vector<glm::dvec2> points;
    const toml::array* list = root_[name].as_array();
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i)
      points.emplace_back(number(fmt::format("{}[{}][0]", name, i).c_str()),
                          number(fmt::format("{}[{}][1]", name, i).c_str()));
    if (points.size() < 2) throw missing(name, "at least two points");
    return points;
  }

 private:
  FileError missing(const std::string& path, const char* what) const {
    return FileError(fmt::format("{}: {} is not {}", file_, path, what));
  }

  std::string file_;
  toml::table root_;
};

}  // namespace

Recipe recipe_of(scene::CloudKind kind) {
  const RecipeFile file(kind);
  Recipe recipe;
  recipe.base_m = file.number("base_m");
  recipe.thickness_m = file.number("thickness_m");
  recipe.cell_m = file.number("cell_m");
  recipe.cover = file.number("cover");
  recipe.opacity = file.number("opacity");
  recipe.extinction_per_km = file.number("extinction_per_km");
  recipe.asymmetry = file.number("asymmetry");
  recipe.thermals = file.thermals();
  recipe.masses = file.octaves("masses");
  recipe.billows = file.octaves("billows");
  recipe.warp = file.number("warp.by");
  recipe.warp_period = file.pair("warp.period");
  recipe.trails = file.trails();
  recipe.patches = file.patches();
  recipe.profile = file.points("profile");
  return recipe;
}

}  // namespace wold::cloud
