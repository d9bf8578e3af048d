#include "cli/commands.h"
#include "cli/output.h"
#include "cli/warnings.h"
#include "phenology/film_season.h"
#include "scene/parse.h"
#include "scene/write.h"

namespace wold::cli {

ExitCode run_check(const std::filesystem::path& scene, const std::vector<std::string>& overrides) {
  const auto [checked, warnings] = scene::read_with_warnings(scene, overrides);
  print_warnings(warnings);
  print_warnings(phenology::as_film(checked));
  print_data(scene::resolved_toml(checked));
  return ExitCode::done;
}

ExitCode run_help_keys() {
  print_data(scene::keys_markdown());
  return ExitCode::done;
}

}  // namespace wold::cli
