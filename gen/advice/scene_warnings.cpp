#include "advice/scene_warnings.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cloud/clouds.h"
#include "cloud/timeline.h"
#include "core/elementary.h"
#include "scene/calendar.h"
#include "scene/shots.h"
#include "scene/text.h"
#include "scene/winter.h"
#include "snow/weather.h"
#include "terrain/elevation.h"
#include "weather/daily_weather.h"

namespace wold::advice {
namespace {

using Warnings = std::vector<std::string>;

/// Fewer are pictures for themselves.
constexpr std::size_t min_film_frames = 8;

/// A way that a layer drifts from one frame to the next.
struct Step {
  double way_m = 0.0;
  int frame = 1;  ///< to which
};

/// The longest between two frames without a cut between them.
Step longest_step(const scene::Scene& scene, const phenology::FilmSeason* season, std::size_t layer,
                  double cell_m) {
  const cloud::Timeline timeline(scene, layer, cell_m, season);
  const auto way_m = [&](int frame) {
    return timeline.at(scene::cloud_time_s(scene, frame)).way_m;
  };
  Step longest;
  for (const scene::Take& take : scene::takes_of(scene)) {
    glm::dvec2 before_m = way_m(take.first);
    for (int frame = take.first + 1; frame <= take.last(); ++frame) {
      const glm::dvec2 now_m = way_m(frame);
      const double step_m = glm::distance(before_m, now_m);
      if (step_m > longest.way_m) longest = {step_m, frame};
      before_m = now_m;
    }
  }
  return longest;
}

/// The table that says how far frames are apart for clouds.
std::string table_of_rate(const scene::Scene& scene, int frame) {
  const scene::Shot* shot = scene::shot_of(scene, frame);
  if (shot == nullptr || scene::is_time_lapse(scene, frame)) return "film";
  return scene::item_name("shots", static_cast<std::size_t>(shot - scene.shots.data()));
}

void warn_of_jumping_clouds(const scene::Scene& scene, const phenology::FilmSeason* season,
                            Warnings& warnings) {
  constexpr double smooth = 0.1;  // of a cell
  if (scene.ageing.frames.size() < min_film_frames) return;
  for (std::size_t i = 0; i < scene.clouds.size(); ++i) {
    const scene::CloudLayer& layer = scene.clouds[i];
    const double cell_m = cloud::cell_m_of(layer);
    const auto [step_m, frame] = longest_step(scene, season, i, cell_m);
    if (step_m <= cell_m) continue;
    const double slower = smooth * cell_m / step_m;
    warnings.push_back(fmt::format(
        "clouds[{0}] jump {1:.3g} m from one frame to the next, more than their cell of {2:.3g} m; "
        "set {3}.frame_seconds = {4:.2g}, or clouds[{0}].speed = {5:.2g}",
        i + 1, step_m, cell_m, table_of_rate(scene, frame),
        slower * scene::cloud_step_s(scene, frame), slower * layer.speed_m_s));
  }
}

/// [weather]'s keys say what it is like, all the time.
bool has_plain_weather(const scene::Scene& scene) {
  return !scene::is_season(scene) && scene.weather.table.empty();
}

/// On the highest ground of a terrain that is known without being made.
double coldest_c(const scene::Scene& scene) {
  const double top_m = scene.terrain.hill_height_m + 3.0 * scene.terrain.relief_m;
  return scene.weather.temperature_c - snow::lapse_k_per_m * top_m;
}

/// Whether it is known that no snow falls: none does, or all that does is rain.
bool has_no_snowfall(const scene::Scene& scene) {
  if (!scene::may_snow(scene)) return true;
  return has_plain_weather(scene) && scene.terrain.elevation.empty() &&
         scene.snowfall.strength == scene::SnowfallStrength::weather &&
         snow::snow_fraction(coldest_c(scene)) <= 0.0;
}

void warn_of_lost_snow(const scene::Scene& scene, Warnings& warnings) {
  const scene::SnowCover& cover = scene.snow_cover;
  if (cover.initial_mm <= 0.0) return;
  if (cover.cover != scene::CoverModel::depth) {
    warnings.push_back(
        fmt::format("the snow of snow_cover.initial is not drawn with snow_cover.cover = \"{}\"; "
                    "set snow_cover.cover = \"depth\"",
                    scene::word_of(cover.cover)));
    return;
  }
  if (!has_plain_weather(scene) || !scene.terrain.elevation.empty()) return;
  constexpr double hours_per_day = 24.0;
  const double melted_mm = cover.melt_mm_per_day * std::max(coldest_c(scene), 0.0) *
                           scene.weather.earlier_h / hours_per_day;
  if (scene::may_snow(scene) || melted_mm < cover.initial_mm) return;
  warnings.push_back(fmt::format(
      "the snow of snow_cover.initial has melted before the first frame; set weather.earlier = 0 "
      "or weather.temperature = -1"));
}

/// A flake is as much fainter as its streak is longer than itself.
void warn_of_streaks(const scene::Scene& scene, Warnings& warnings) {
  constexpr double flake_m = 0.005, fall_m_s = 1.0;
  constexpr double min_opacity = 0.05;
  static const scene::Snowfall usual;
  if (!scene::may_snow(scene) || scene.snowfall.motion != scene::Law::physical) return;
  const double speed_m_s = math::hypot(fall_m_s, scene.wind.speed_m_s);
  const double opacity = flake_m / (flake_m + speed_m_s * scene.snowfall.shutter_s);
  if (opacity >= min_opacity) return;
  warnings.push_back(fmt::format(
      "flakes streak over {:.2g} m while the picture is exposed, too faint to be seen; set "
      "snowfall.shutter = {:.3g}",
      speed_m_s * scene.snowfall.shutter_s, usual.shutter_s));
}

/// A tornado is made of flakes.
void warn_of_unseen_tornado(const scene::Scene& scene, Warnings& warnings) {
  if (scene.wind.field != scene::WindPattern::tornado || !has_no_snowfall(scene)) return;
  warnings.emplace_back(
      "the tornado of wind.field whirls flakes up, and no snow falls: it is not seen; set "
      "snowfall.strength = \"moderate\"");
}

/// Ridges and valleys that the elevation model has and the terrain does not take.
void warn_of_coarse_terrain(const scene::Terrain& terrain, Warnings& warnings) {
  constexpr double much = 1.5;
  constexpr int most_samples = 4097;
  const double step_m = terrain.size_m / (terrain.samples - 1.0);
  const double cell_m = terrain::elevation_cell_m(terrain);
  if (step_m < much * cell_m) return;
  const double samples = std::min<double>(std::ceil(terrain.size_m / cell_m) + 1.0, most_samples);
  if (samples <= terrain.samples) return;
  warnings.push_back(
      fmt::format("the terrain has a height each {:.3g} m and terrain.elevation one each {:.3g} m, "
                  "so that ridges are lost; set terrain.samples = {:.0f}",
                  step_m, cell_m, samples));
}

/// A square that nobody chose shows a few cells of the elevation model, which are smooth.
void warn_of_small_square(const scene::Terrain& terrain, Warnings& warnings) {
  constexpr double few_cells = 10.0;
  static const scene::Terrain plain;
  if (terrain.size_m != plain.size_m) return;
  const double cell_m = terrain::elevation_cell_m(terrain);
  if (terrain.size_m >= few_cells * cell_m) return;
  warnings.push_back(
      fmt::format("the terrain is {:.3g} m wide, {:.2g} cells of terrain.elevation; set "
                  "terrain.size, and camera.eye and camera.target within it, or let wold new "
                  "--terrain choose them",
                  terrain.size_m, terrain.size_m / cell_m));
}

/// Of a model whose degrees are taken for metres no other warning about its size is right.
void warn_of_elevation(const scene::Terrain& terrain, Warnings& warnings) {
  if (terrain.elevation.empty()) return;
  if (terrain::elevation_looks_like_degrees(terrain)) {
    warnings.emplace_back(
        "terrain.elevation does not say its coordinate system and is taken for metres, but looks "
        "like degrees; set terrain.system = \"EPSG:4326\"");
    return;
  }
  warn_of_coarse_terrain(terrain, warnings);
  warn_of_small_square(terrain, warnings);
}

/// A camera that nobody placed stands in the corner of a large square.
void warn_of_camera_in_the_corner(const scene::Scene& scene, Warnings& warnings) {
  constexpr double much_larger = 10.0;
  static const scene::Scene plain;
  const scene::Camera& camera = scene.camera;
  if (scene.terrain.size_m < much_larger * plain.terrain.size_m || !scene.shots.empty() ||
      camera.eye_m != plain.camera.eye_m || camera.target_m != plain.camera.target_m)
    return;
  warnings.push_back(fmt::format(
      "the camera has its default place, in the corner of {:.3g} m of terrain; set camera.eye and "
      "camera.target{}",
      scene.terrain.size_m,
      scene.terrain.elevation.empty() ? "" : ", or let wold new --terrain choose them"));
}

/// Clouds of a layer are seen in dry air alone.
void warn_of_hidden_clouds(const scene::Scene& scene, Warnings& warnings) {
  if (scene::is_season(scene) || scene.clouds.empty() || scene.weather.precipitation_mm_h <= 0.0 ||
      !scene.weather.table.empty())
    return;
  warnings.emplace_back(
      "weather.precipitation hides the sun and [[clouds]]: the sky is overcast as far as it rains "
      "or snows");
}

void warn_of_late_table(const scene::Scene& scene, Warnings& warnings) {
  constexpr std::chrono::days enough(60);
  if (!scene::is_season(scene) || scene.season.table.empty()) return;
  const bool keys_wither = std::ranges::any_of(
      scene.season_keys, [](const scene::SeasonKey& key) { return key.weathering.has_value(); });
  if (keys_wither) return;
  const std::chrono::sys_days first = scene::date_of(scene.season.first);
  const std::chrono::sys_days begins =
      weather::read_daily_weather(scene.season.table, scene.sun.latitude_deg).front().date;
  if (first - begins >= enough) return;
  const std::chrono::year_month_day later(begins + enough);
  warnings.push_back(fmt::format(
      "season.table begins {} days before the first frame, and grass follows the weather of "
      "months; let it begin on {:%Y-%m-%d} or earlier, or set season.first = [{}, {}, {}] or later",
      (first - begins).count(), first - enough, static_cast<int>(later.year()),
      static_cast<unsigned>(later.month()), static_cast<unsigned>(later.day())));
}

}  // namespace

Warnings scene_warnings(const scene::Scene& film, const phenology::FilmSeason* season) {
  Warnings warnings = grass_warnings(film);
  warn_of_jumping_clouds(film, season, warnings);
  warn_of_lost_snow(film, warnings);
  warn_of_streaks(film, warnings);
  warn_of_unseen_tornado(film, warnings);
  warn_of_late_table(film, warnings);
  warn_of_elevation(film.terrain, warnings);
  warn_of_camera_in_the_corner(film, warnings);
  warn_of_hidden_clouds(film, warnings);
  for (const auto& more : {season_warnings(film), unused_key_warnings(film)})
    warnings.insert(warnings.end(), more.begin(), more.end());
  return warnings;
}

}  // namespace wold::advice
