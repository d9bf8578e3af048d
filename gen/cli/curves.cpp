#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <span>

#include "cli/commands.h"
#include "cli/output.h"
#include "cli/warnings.h"
#include "core/files.h"
#include "core/parallel.h"
#include "grass/ageing/withering_curves.h"
#include "phenology/film_season.h"
#include "phenology/season.h"
#include "report/curves_figure.h"
#include "report/curves_table.h"
#include "report/season_curves.h"
#include "scene/calendar.h"
#include "scene/parse.h"
#include "scene/text.h"
#include "work/kept_inputs.h"

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
  return form == Form::figure ? report::chart::svg(report::withering_figure(scene.name, curves))
                              : csv(report::withering_table(curves));
}

/// What a scene's season makes of its days; its keys may say how the meadow withers.
std::vector<phenology::SeasonDay> days_of(const scene::Scene& scene) {
  const phenology::FilmSeason film(scene);
  std::vector<phenology::SeasonDay> days =
      phenology::season_of(film.days(), scene.snow_cover.initial_mm);
  for (std::size_t i = 0; i < days.size(); ++i) days[i].weathering_degree = film.weathering()[i];
  return days;
}

std::string season_file(const scene::Scene& scene, std::span<const phenology::SeasonDay> days,
                        Form form) {
  return form == Form::figure ? report::chart::svg(report::season_figure(scene.name, days))
                              : csv(report::season_table(days));
}

std::string curves_file(const scene::Scene& scene, const std::filesystem::path& weather,
                        Form form) {
  if (!weather.empty())
    return season_file(
        scene, phenology::season_of(weather::read_daily_weather(weather, scene.sun.latitude_deg)),
        form);
  return scene::is_season(scene) ? season_file(scene, days_of(scene), form)
                                 : ageing_file(scene, form);
}

}  // namespace

ExitCode run_curves(const CurvesOptions& options) {
  const Form form = form_of(options.out);
  const auto [scene, warnings] = scene::read_with_warnings(options.scene, options.overrides);
  print_warnings(warnings);
  std::vector<std::filesystem::path> inputs = work::input_files(options.scene, scene);
  inputs.push_back(options.weather);
  work::require_no_input(options.out, inputs);
  write_file(options.out, curves_file(scene, options.weather, form));
  print_message(fmt::format("wrote {}", options.out.string()));
  return ExitCode::done;
}

}  // namespace wold::cli
