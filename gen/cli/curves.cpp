#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/warnings.h"
#include "console/output.h"
#include "core/files.h"
#include "film/machine_check.h"
#include "report/curves_file.h"
#include "scene/parse.h"
#include "work/kept_inputs.h"

namespace wold::cli {

ExitCode run_curves(const CurvesOptions& options) {
  const report::CurvesForm form = report::curves_form_of(options.out);
  const auto [scene, places, warnings] =
      scene::read_located_scene(options.scene, options.overrides);
  print_warnings(warnings);
  film::require_files(scene, places);
  std::vector<std::filesystem::path> inputs = work::input_files(options.scene, scene);
  inputs.push_back(options.weather);
  work::require_no_input(options.out, inputs);
  write_file(options.out, report::curves_file(scene, options.weather, form));
  console::print_message(fmt::format("wrote {}", options.out.string()));
  return ExitCode::done;
}

}  // namespace wold::cli
