#include "cli/commands.h"
#include "cli/warnings.h"
#include "console/output.h"
#include "film/machine_check.h"
#include "pages/scene_json.h"
#include "scene/parse.h"
#include "scene/write.h"

namespace wold::cli {

ExitCode run_check(const std::filesystem::path& scene, const std::vector<std::string>& overrides,
                   bool json) {
  const scene::LocatedScene read = scene::read_located_scene(scene, overrides);
  film::require_files(read.scene, read.places);
  print_warnings(read.warnings);
  const auto season = phenology::film_season(read.scene);
  print_warnings(phenology::as_film(read.scene, season.get()), season.get());
  console::print_data(json ? pages::scene_json(read.scene) : scene::resolved_toml(read.scene));
  return ExitCode::done;
}

}  // namespace wold::cli
