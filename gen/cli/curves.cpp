#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "cli/commands.h"
#include "cli/curves_figure.h"
#include "cli/curves_table.h"
#include "cli/output.h"
#include "cli/season_curves.h"
#include "core/files.h"
#include "core/parallel.h"
#include "grass/withering_curves.h"
#include "scene/parse.h"
#include "scene/text.h"
#include "season/season.h"

namespace wold::cli {
namespace {

enum class Form { figure, table };

/// The file's form by its extension, in small or capital letters.
Form form_of(const std::filesystem::path& out) {
  std::string extension = out.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".svg") return Form::figure;
  if (extension == ".csv") return Form::table;
  throw InputError(fmt::format(
      "--out: found {}, expected a file name that ends in .svg (figure) or .csv (table)",
      out.empty() ? "nothing" : scene::in_quotes(out.string())));
}

std::string ageing_file(const scene::Scene& scene, Form form) {
  const ThreadLimit limit(scene.render.threads);
  const grass::WitheringCurves curves = grass::withering_curves(scene);
  return form == Form::figure ? chart::svg(withering_figure(scene.name, curves))
                              : csv(withering_table(curves));
}

std::string season_file(const scene::Scene& scene, const std::filesystem::path& weather,
                        Form form) {
  const auto days = season::season_of(season::read_daily_weather(weather, scene.sun.latitude_deg));
  return form == Form::figure ? chart::svg(season_figure(scene.name, days))
                              : csv(season_table(days));
}

}  // namespace

ExitCode run_curves(const CurvesOptions& options) {
  const Form form = form_of(options.out);
  const scene::Scene scene = scene::read_scene(options.scene, options.overrides);
  write_file(options.out, options.weather.empty() ? ageing_file(scene, form)
                                                  : season_file(scene, options.weather, form));
  print_message(fmt::format("wrote {}", options.out.string()));
  return ExitCode::done;
}

}  // namespace wold::cli
