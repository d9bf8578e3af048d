#include "maps/maps.h"

#include "cli/commands.h"
#include "cli/warnings.h"
#include "console/output.h"
#include "core/files.h"
#include "core/parallel.h"
#include "core/temporary_name.h"
#include "film/machine_check.h"
#include "film/scratch_folder.h"
#include "phenology/film_season.h"
#include "scene/parse.h"
#include "work/build_hash.h"
#include "work/job.h"
#include "work/kept_inputs.h"
#include "work/scene_facts.h"

namespace wold::cli {
namespace fs = std::filesystem;
namespace {

std::string listed(const std::vector<maps::MapFile>& files, bool json) {
  if (json) return maps::as_json(files);
  std::string text;
  for (const maps::MapFile& map : files) text += map.file.string() + "\n";
  return text;
}

}  // namespace

ExitCode run_maps(const MapsOptions& options, Progress& progress) {
  const scene::LocatedScene read = scene::read_located_scene(options.scene, options.overrides);
  film::require_files(read.scene, read.places);
  const auto season = phenology::film_season(read.scene);
  const scene::Scene scene = phenology::as_film(read.scene, season.get());
  const std::vector<int> frames = work::chosen_frames(options.frames, scene);
  const fs::path folder = options.out.empty() ? fs::path("out") / scene.name / "maps" : options.out;
  const std::vector<fs::path> inputs = work::input_files(options.scene, scene);
  for (const fs::path& file : maps::map_files(folder, frames)) work::require_no_input(file, inputs);
  print_warnings(read.warnings);
  print_warnings(scene, season.get());
  const ThreadLimit limit(scene.render.threads);
  const film::ScratchFolder scratch(temporary_name(folder / "snow"));
  const std::string source =
      content_hash(work::hash_of(work::facts_of(scene)) + work::hash_of_build());
  console::print_data(
      listed(maps::write_maps(scene, season, frames, folder, scratch.path(), source, progress),
             options.json));
  return ExitCode::done;
}

}  // namespace wold::cli
