#include "cli/commands.h"
#include "cli/output.h"
#include "scene/parse.h"
#include "scene/write.h"

namespace wold::cli {

ExitCode run_check(const std::filesystem::path& scene, const std::vector<std::string>& overrides) {
  print_data(scene::resolved_toml(scene::read_scene(scene, overrides)));
  return ExitCode::done;
}

ExitCode run_help_keys() {
  print_data(scene::keys_markdown());
  return ExitCode::done;
}

}  // namespace wold::cli
