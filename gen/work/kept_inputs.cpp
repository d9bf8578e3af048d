#include "work/kept_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "core/files.h"
#include "film/exporters.h"
#include "scene/registry.h"
#include "scene/write.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

/// Whether a run writes there in its output folder.
bool is_written(std::string_view name) {
  constexpr std::array<std::string_view, 9> always = {"scene.toml", "manifest.json", "texels",
                                                      "clouds",     "snow",          "passes",
                                                      "frames",     "logs",          "tasks"};
  return std::ranges::count(always, name) > 0 ||
         std::ranges::any_of(film::exporters(), [&](const exporter::Exporter* one) {
           return exporter::writes(*one, name);
         });
}

void append_files(const std::vector<scene::Key>& keys, const scene::Scene& scene,
                  std::vector<fs::path>& files) {
  for (const scene::Key& key : keys) {
    const scene::Value value = key.get(scene);
    if (key.kind == scene::Kind::file) files.emplace_back(std::get<std::string>(value));
    if (key.kind == scene::Kind::files)
      for (const std::string& file : std::get<std::vector<std::string>>(value))
        files.emplace_back(file);
  }
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code missing;
  return fs::equivalent(a, b, missing);
}

/// Whether a run would leave its scene file as it is.
bool stays(const fs::path& input, const fs::path& name, const scene::Scene& scene) {
  return name == "scene.toml" && read_file(input) == scene::resolved_toml(scene);
}

}  // namespace

std::vector<fs::path> input_files(const fs::path& file, const scene::Scene& scene) {
  std::vector<fs::path> files = {file};
  append_files(scene::registry(), scene, files);
  for (const scene::TableArray& array : scene::table_arrays())
    for (std::size_t item = 0; item < array.count(scene); ++item)
      append_files(scene::item_keys(array, item), scene, files);
  std::erase(files, fs::path());
  return files;
}

void require_no_input(const fs::path& output, std::span<const fs::path> inputs,
                      std::string_view option) {
  for (const fs::path& input : inputs)
    if (is_same_file(output, input))
      throw InputError(
          fmt::format("{}: found {}, which is read, too, and would be lost; expected another file",
                      option, output.string()));
}

void require_inputs_kept(const fs::path& folder, std::span<const fs::path> inputs,
                         const scene::Scene& scene) {
  std::error_code missing;
  const fs::path own = fs::canonical(folder, missing);
  if (missing) return;  // nothing can be lost in it
  for (const fs::path& input : inputs) {
    const fs::path place = fs::canonical(input, missing);
    const fs::path name = place.lexically_relative(own);
    const std::string text = name.generic_string();
    if (!is_written(text.substr(0, text.find('/')))) continue;
    if (!stays(input, name, scene))
      throw InputError(fmt::format(
          "--out: found the input {} where a run into {} writes, too; copy it to another place, or "
          "choose another folder",
          input.string(), folder.string()));
  }
}

}  // namespace wold::work
