#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/warnings.h"
#include "console/output.h"
#include "core/files.h"
#include "core/image.h"
#include "core/parallel.h"
#include "core/temporary_name.h"
#include "film/machine_check.h"
#include "film/scratch_folder.h"
#include "phenology/film_season.h"
#include "scene/parse.h"
#include "sketch/contact_sheet.h"
#include "work/kept_inputs.h"

namespace wold::cli {
namespace fs = std::filesystem;
namespace {

fs::path file_of(const PreviewOptions& options, const scene::Scene& scene) {
  fs::path file = options.out.empty() ? fs::path("out") / scene.name / "preview.png" : options.out;
  if (file.extension() != ".png")
    throw InputError(
        fmt::format("--out: found {}, expected a file name that ends in .png", file.string()));
  return file;
}

}  // namespace

ExitCode run_preview(const PreviewOptions& options, Progress& progress) {
  const scene::LocatedScene read = scene::read_located_scene(options.scene, options.overrides);
  film::require_files(read.scene, read.places);
  const auto season = phenology::film_season(read.scene);
  const scene::Scene scene = phenology::as_film(read.scene, season.get());
  const fs::path file = file_of(options, scene);
  work::require_no_input(file, work::input_files(options.scene, scene));
  print_warnings(read.warnings);
  print_warnings(scene, season.get());
  if (file.has_parent_path()) make_folder(file.parent_path());
  const ThreadLimit limit(scene.render.threads);
  const film::ScratchFolder scratch(temporary_name(file.parent_path() / "preview_work"));
  if (!sketch::has_labels())
    console::print_message(
        "labels are left out: DejaVu Sans is missing; apt-get install fonts-dejavu-core");
  write_image(file, sketch::contact_sheet(scene, season, scratch.path(), progress),
              PixelFormat::uint8);
  console::print_data(file.string() + "\n");
  return ExitCode::done;
}

}  // namespace wold::cli
