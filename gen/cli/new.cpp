#include <fmt/format.h>

#include "cli/commands.h"
#include "console/output.h"
#include "core/files.h"
#include "place/starter_place.h"
#include "scene/parse.h"
#include "scene/starter.h"

namespace wold::cli {

ExitCode run_new(const std::string& name, const std::string& kind,
                 const std::optional<std::string>& terrain) {
  constexpr std::string_view extension = ".toml";
  const std::string stem =
      name.ends_with(extension) ? name.substr(0, name.size() - extension.size()) : name;
  std::string text = scene::starter_scene(stem, kind);
  const std::filesystem::path file = stem + std::string(extension);
  if (std::filesystem::exists(file))
    throw InputError(fmt::format("{} exists already; choose another name", file.string()));
  if (terrain) text = scene::starter_scene(stem, kind, place::starter_place(*terrain, kind));
  scene::parse_scene(text, file.string());  // real places may be at fault
  write_file(file, text);
  console::print_message(fmt::format(
      "wrote {0}; look at it with wold preview {0}, make it with wold render {0}", file.string()));
  return ExitCode::done;
}

}  // namespace wold::cli
