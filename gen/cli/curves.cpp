#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "cli/commands.h"
#include "cli/warnings.h"
#include "console/output.h"
#include "core/files.h"
#include "film/machine_check.h"
#include "report/curves_file.h"
#include "scene/parse.h"
#include "scene/text.h"
#include "work/kept_inputs.h"

namespace wold::cli {
namespace {

/// The file's form by its extension, in small or capital letters.
report::CurvesForm form_of(const std::filesystem::path& out) {
  std::string extension = out.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".svg") return report::CurvesForm::figure;
  if (extension == ".csv") return report::CurvesForm::table;
  throw InputError(fmt::format(
      "--out: found {}, expected a file name that ends in .svg (figure) or .csv (table)",
      out.empty() ? "nothing" : scene::in_quotes(out.string())));
}

}  // namespace

ExitCode run_curves(const CurvesOptions& options) {
  const report::CurvesForm form = form_of(options.out);
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
