#include "work/scene_facts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "core/files.h"
#include "scene/registry.h"

namespace wold::work {
namespace {

bool is_name_of_shot(const std::string& key) {
  return key.starts_with("shots[") && scene::leaf_of(key) == "name";
}

/// How fast a film is played says how many frames its shots have, but nothing of any other film.
/// That it has a shutter says which passes there are, which their tasks know.
bool changes_no_file(const scene::Scene& scene, const std::string& key) {
  if (key == "film.frames_per_second") return scene.shots.empty();
  if (is_name_of_shot(key)) return true;
  return key == "name" || key == "film.shutter" || key == "render.renderer" ||
         key == "render.device" || key == "render.threads" || key == "render.timeout";
}

/// Block by block: an elevation model may be larger than memory.
std::string hash_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
  std::string hashes, block(1 << 20, '\0');
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0)
    hashes += content_hash({block.data(), static_cast<std::size_t>(file.gcount())});
  return content_hash(hashes);
}

std::string fact(const scene::Key& key, const scene::Value& value) {
  std::vector<std::string> files;
  if (key.kind == scene::Kind::file) files = {std::get<std::string>(value)};
  if (key.kind == scene::Kind::files) files = std::get<std::vector<std::string>>(value);
  if (files.empty() || files.front().empty()) return scene::toml_text(value);
  for (std::string& file : files) file = hash_of_file(file);
  return fmt::format("{}", fmt::join(files, " "));
}

}  // namespace

SceneFacts facts_of(const scene::Scene& scene) {
  SceneFacts facts;
  const auto add = [&](const std::vector<scene::Key>& keys) {
    for (const scene::Key& key : keys)
      if (!changes_no_file(scene, key.name)) facts[key.name] = fact(key, key.get(scene));
  };
  add(scene::registry());
  for (const scene::TableArray& array : scene::table_arrays())
    for (std::size_t item = 0; item < array.count(scene); ++item)
      add(scene::item_keys(array, item));
  return facts;
}

std::string hash_of(const SceneFacts& facts) {
  std::string text;
  for (const auto& [key, value] : facts) text += fmt::format("{} = {}\n", key, value);
  return content_hash(text);
}

std::vector<std::string> changed_keys(const SceneFacts& now, const SceneFacts& then) {
  std::vector<SceneFacts::value_type> pairs;
  std::set_symmetric_difference(now.begin(), now.end(), then.begin(), then.end(),
                                std::back_inserter(pairs));
  std::vector<std::string> keys;
  keys.reserve(pairs.size());
  for (const auto& pair : pairs) keys.push_back(pair.first);
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

}  // namespace wold::work
