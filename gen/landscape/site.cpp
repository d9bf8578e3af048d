#include "landscape/site.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/files.h"
#include "landscape/cell_window.h"
#include "landscape/ground_grids.h"
#include "landscape/growth.h"
#include "scene/winter.h"
#include "terrain/ground.h"
#include "terrain/lighting.h"

namespace wold::landscape {

namespace {

namespace fs = std::filesystem;

/// An empty folder for tiled pictures: those of another time say nothing of this scene.
void clear_pictures(const fs::path& folder) {
  make_folder(folder);
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".tif") old.push_back(entry.path());
  for (const fs::path& picture : old) fs::remove(picture);
}

std::unique_ptr<snow::LargeCover> large_cover(const scene::Scene& scene, const Heightfield& terrain,
                                              const snow::WeatherFunction& weather,
                                              const fs::path& folder) {
  if (!is_large(scene) || scene.snow_cover.cover != "depth" || !scene::may_lie(scene))
    return nullptr;
  if (folder.empty()) throw std::invalid_argument("the snow of a large terrain needs a folder");
  clear_pictures(folder);
  return std::make_unique<snow::LargeCover>(
      scene, snow::large_ground(terrain), weather, folder,
      snow::LargeCover::Limits{.view_samples = cover_samples(scene)});
}

/// What small terrains have, with the usual steps.
GroundPart whole_ground(const scene::Scene& scene, const Heightfield& terrain,
                        const light::Daylight& day) {
  FactorMap growth = growth_map(scene, terrain);
  terrain::GroundLight light = terrain::ground_light(terrain, day);
  ColourMap reflectance =
      terrain::ground_reflectance(terrain, day.sun_direction(), scene.terrain, scene.seed, growth,
                                  canopy_transmittance(scene.grass));
  return {std::move(growth), std::move(light), std::move(reflectance)};
}

/// All of it.
GroundPart ground_of(const scene::Scene& scene, const Heightfield& terrain,
                     const light::Daylight& day, std::optional<int> samples) {
  if (is_large(scene)) return ground_part(scene, terrain, day, whole_grid(scene));
  if (samples) return ground_part(scene, terrain, day, {terrain.square(), *samples});
  return whole_ground(scene, terrain, day);
}

}  // namespace

Snow::Snow(const scene::Scene& scene, const Heightfield& terrain, const fs::path& folder)
    : weather(scene),
      pictures(scene.seed),
      ground(scene, terrain, [made = weather](double time_s) { return made.at(time_s); }),
      large(large_cover(
          scene, terrain, [made = weather](double time_s) { return made.at(time_s); }, folder)) {}

GroundGrid light_grid(const Heightfield& terrain, const GroundGrid& grid) {
  constexpr double least_samples = 17.0;
  const double step_m = std::max(grid.step_m(), terrain.step_m());
  const double samples = std::ceil(grid.square.size_m / step_m - 1e-9) + 1.0;
  return {grid.square, static_cast<int>(std::max(samples, least_samples))};
}

GroundPart ground_part(const scene::Scene& scene, const Heightfield& terrain,
                       const light::Daylight& day, const GroundGrid& grid) {
  FactorMap growth = growth_map(scene, terrain, grid);
  terrain::GroundLight light = terrain::ground_light(terrain, day, light_grid(terrain, grid));
  ColourMap reflectance =
      terrain::ground_reflectance(terrain, day.sun_direction(), scene.terrain, scene.seed, growth,
                                  canopy_transmittance(scene.grass), grid);
  return {std::move(growth), std::move(light), std::move(reflectance)};
}

const FactorMap& growth_of_cells(const Site& site) {
  return site.growth_of_window ? *site.growth_of_window : site.growth;
}

Site make_site(const scene::Scene& scene, const fs::path& snow_folder,
               std::optional<int> ground_samples) {
  Heightfield terrain = terrain::make_ground(scene.terrain, scene.seed);
  const light::Daylight day(scene.sun, scene.sky);
  const bool large = is_large(scene);
  GroundPart ground = ground_of(scene, terrain, day, ground_samples);
  std::optional<FactorMap> growth_of_window;
  if (large) growth_of_window = growth_map(scene, terrain, window_grid(scene));
  std::optional<cloud::Clouds> clouds;
  if (!scene.clouds.empty()) clouds.emplace(scene, cloud::Clouds::usual_pixel_m(scene));
  std::shared_ptr<const Snow> snow;
  if (scene::may_snow(scene) || scene::may_lie(scene))
    snow = std::make_shared<const Snow>(scene, terrain, snow_folder);
  return {std::move(terrain),
          std::move(ground.growth),
          std::move(growth_of_window),
          day,
          std::move(ground.light),
          std::move(ground.reflectance),
          std::move(clouds),
          std::move(snow),
          ground_samples};
}

double leaf_area_index(const scene::Grass& grass) {
  const double blade_m2 = 0.5 * grass.height_m * grass.width_m;
  return grass.blades * blade_m2 / (grass.patch_m * grass.patch_m);
}

double canopy_transmittance(const scene::Grass& grass) {
  constexpr double ross = 0.5;
  constexpr double mean_slant_cosine = 0.5;
  return std::exp(-ross * leaf_area_index(grass) / mean_slant_cosine);
}

}  // namespace wold::landscape
