#include "report/curves_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <span>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/table.h"
#include "grass/ageing/withering_curves.h"
#include "phenology/film_season.h"
#include "phenology/season.h"
#include "report/curves_figure.h"
#include "report/curves_table.h"
#include "report/season_curves.h"
#include "scene/calendar.h"
#include "scene/text.h"
#include "weather/daily_weather.h"

namespace wold::report {
namespace {

std::string ageing_file(const scene::Scene& scene, CurvesForm form) {
  const ThreadLimit limit(scene.render.threads);
  const grass::WitheringCurves curves = grass::withering_curves(scene);
  return form == CurvesForm::figure ? chart::svg(withering_figure(scene.name, curves))
                                    : csv(withering_table(curves));
}

/// What a scene's season makes of its days; its keys may say how the meadow withers.
std::vector<phenology::SeasonDay> days_of(const scene::Scene& scene,
                                          const phenology::FilmSeason& film) {
  std::vector<phenology::SeasonDay> days =
      phenology::season_of(film.days(), scene.snow_cover.initial_mm);
  for (std::size_t i = 0; i < days.size(); ++i) days[i].weathering_degree = film.weathering()[i];
  return days;
}

std::string season_file(const scene::Scene& scene, std::span<const phenology::SeasonDay> days,
                        CurvesForm form) {
  return form == CurvesForm::figure ? chart::svg(season_figure(scene.name, days))
                                    : csv(season_table(days));
}

}  // namespace

CurvesForm curves_form_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".svg") return CurvesForm::figure;
  if (extension == ".csv") return CurvesForm::table;
  throw InputError(fmt::format(
      "--out: found {}, expected a file name that ends in .svg (figure) or .csv (table)",
      file.empty() ? "nothing" : scene::in_quotes(file.string())));
}

std::string curves_file(const scene::Scene& scene, const std::filesystem::path& weather,
                        CurvesForm form) {
  if (!weather.empty())
    return season_file(
        scene, phenology::season_of(weather::read_daily_weather(weather, scene.sun.latitude_deg)),
        form);
  const auto season = phenology::film_season(scene);
  return season ? season_file(scene, days_of(scene, *season), form) : ageing_file(scene, form);
}

}  // namespace wold::report
