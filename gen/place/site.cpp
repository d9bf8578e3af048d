#include "place/site.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/coarser_parts.h"
#include "core/elementary.h"
#include "core/files.h"
#include "core/filled_map.h"
#include "place/air.h"
#include "place/cell_window.h"
#include "place/each_in_view.h"
#include "place/ground_grids.h"
#include "place/ground_views.h"
#include "place/growth.h"
#include "place/scene_ground.h"
#include "place/view.h"
#include "scene/calendar.h"
#include "scene/species.h"
#include "scene/sun_path.h"
#include "scene/winter.h"
#include "terrain/ledges.h"
#include "terrain/lighting.h"

namespace wold::place {

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
  if (!is_large(scene) || scene.snow_cover.cover != scene::CoverModel::depth ||
      !scene::may_lie(scene))
    return nullptr;
  if (folder.empty()) throw std::invalid_argument("the snow of a large terrain needs a folder");
  clear_pictures(folder);
  return std::make_unique<snow::LargeCover>(
      scene, snow::large_ground(terrain), weather, folder,
      snow::LargeCover::Limits{.view_samples = cover_samples(scene)});
}

/// The light of a clear sky on a surface, from a value for each of `fineness`: of its own grid, or
/// of a coarser one on the same square, between whose values nobody looks.
terrain::GroundLight lit(const Site& site, const terrain::Surface& surface,
                         const GroundGrid& fineness) {
  constexpr int steps = 2;  // values between two, smoothed over one
  const GroundGrid grid = light_grid(site.terrain, fineness, site.sketch);
  const bool as_fine =
      grid.samples == light_grid(site.terrain, surface.grid(), site.sketch).samples;
  const RowParts parts = coarser_parts(surface.grid(), surface.parts(), grid, steps);
  return surface.lit(terrain::ground_light(site.terrain, site.day, grid, site.land_shadow.get(),
                                           parts, /*smoothed=*/as_fine),
                     site.day.sun_direction());
}

/// A part of a site's ground on which that grows, in light as fine as a grid.
GroundPart lit_part(const scene::Scene& scene, const Site& site, const terrain::Surface& surface,
                    const GroundGrid& fineness, FactorMap growth) {
  terrain::GroundLight light = lit(site, surface, fineness);
  ColourMap reflectance = terrain::ground_reflectance(surface, site.day.sun_direction(),
                                                      scene.terrain, scene.seed, growth);
  return {std::move(growth), std::move(light), std::move(reflectance)};
}

/// Those of a large terrain that snow may lie on.
std::optional<FactorMap> ledges(const scene::Scene& scene, const Snow* snow,
                                const terrain::Surface& surface, const FactorMap& growth) {
  if (snow == nullptr || !snow->large) return std::nullopt;
  return terrain::ledges(surface, growth, scene.terrain, scene.seed);
}

/// Where maps of the whole ground have their values: as the pictures of a large terrain need them,
/// as many as a sketch has, or nowhere else than usual.
std::optional<GroundGrid> grid_of_ground(const scene::Scene& scene, const Heightfield& terrain,
                                         const std::optional<Sketch>& sketch) {
  if (is_large(scene)) return whole_grid(scene);
  if (sketch) return GroundGrid{terrain.square(), sketch->ground_samples};
  return std::nullopt;
}

/// Rows of a grid that views show, and some steps about them.
RowParts rows_seen(const GroundGrid& grid, const Site& site, const std::vector<View>& views,
                   double more_steps) {
  const double step_m = grid.step_m();
  return rows_in_view(grid, site.terrain, views,
                      margin_in_view_m(views.front(), step_m) + more_steps * step_m);
}

/// The ground of a large terrain in the light of a day: as its picture needs it where a frame, or
/// any of the film without one, shows it. Elsewhere, where it only lights and is mirrored, every
/// fourth sample along both axes says what lies between: on the mean the same.
GroundPart large_ground(const scene::Scene& scene, const Site& site, std::optional<int> frame,
                        FactorMap growth) {
  constexpr int coarser = 4;
  const GroundGrid fine = whole_grid(scene);
  const std::vector<View> views = frame ? std::vector{view_of_frame(scene, site.terrain, *frame)}
                                        : views_of_film(scene, site.terrain);
  if (views.empty()) return lit_part(scene, site, site.surface(fine), fine, std::move(growth));
  const auto seen = [&](double more_steps) { return rows_seen(fine, site, views, more_steps); };
  const GroundGrid coarse{fine.square, (fine.samples - 1) / coarser + 1};
  const GroundPart all =
      lit_part(scene, site, site.surface(fine, lattice(fine, coarse)), coarse, growth);
  GroundPart part = lit_part(scene, site, site.surface(fine, seen(2.0)), fine, std::move(growth));
  const RowParts of_picture = seen(0.0);
  const auto completed = [&](const auto& map, const auto& of_all) {
    // Light without bumps is on its own grid.
    const GroundGrid grid{map.square(), map.samples()};
    const bool sampled = of_all.samples() == fine.samples;
    return filled_up(map, coarser_parts(fine, of_picture, grid, /*steps=*/1),
                     sampled ? on_lattice(of_all, coarse) : of_all);
  };
  part.light = {completed(part.light.sun, all.light.sun), completed(part.light.sky, all.light.sky),
                completed(part.light.overcast, all.light.overcast)};
  part.reflectance = completed(part.reflectance, all.reflectance);
  return part;
}

/// The whole ground in the light of a day, on a grid or with the usual steps.
GroundPart whole_ground(const scene::Scene& scene, const Site& site,
                        const std::optional<GroundGrid>& grid, FactorMap growth) {
  const light::Daylight& day = site.day;
  if (grid) return lit_part(scene, site, site.surface(*grid), *grid, std::move(growth));
  terrain::GroundLight light = whole_light(site, site.terrain);
  ColourMap reflectance = terrain::ground_reflectance(
      site.surface(picture_grid(scene)), day.sun_direction(), scene.terrain, scene.seed, growth);
  return {std::move(growth), std::move(light), std::move(reflectance)};
}

/// Land that is made up casts none: nobody knows what is there.
std::shared_ptr<const terrain::LandShadow> land_shadow(const scene::Scene& scene,
                                                       const Site& site) {
  if (scene.terrain.elevation.empty()) return nullptr;
  return std::make_shared<const terrain::LandShadow>(*site.surroundings, site.day.sun_direction());
}

/// Sets the light of its day on a site's ground, and what the ground makes of it: for a frame, or
/// for all of the film.
void light_ground(const scene::Scene& scene, Site& site, std::optional<int> frame = {}) {
  site.land_shadow = land_shadow(scene, site);
  GroundPart ground =
      is_large(scene) ? large_ground(scene, site, frame, std::move(site.growth))
                      : whole_ground(scene, site, grid_of_ground(scene, site.terrain, site.sketch),
                                     std::move(site.growth));
  site.growth = std::move(ground.growth);
  site.light = std::move(ground.light);
  site.ground_reflectance = std::move(ground.reflectance);
}

/// The scene with its sun where it stands in the middle of the film.
scene::Scene half_way_through(scene::Scene scene) {
  scene.sun = scene::sun_on_way(scene, scene::take_of(scene, scene::frame_count(scene) / 2), 0.5);
  return scene;
}

/// How far out land is seen: where haze leaves 1 % of it.
double farthest_land_m(const scene::Scene& scene) {
  constexpr double least_m = 10e3, most_m = 150e3;
  return std::clamp(1.2 * scene.sky.visual_range_m, least_m, most_m);
}

/// `growth_of_cells`: none where a sketch has its own.
Site site_on(const scene::Scene& scene, terrain::Ground ground,
             std::optional<FactorMap> growth_of_cells,
             std::shared_ptr<const phenology::FilmSeason> season, const fs::path& snow_folder,
             const std::optional<Sketch>& sketch) {
  const terrain::KnownGround known = ground.known();  // stays where it is when the ground moves
  auto [terrain, finer, water, cover, scree, photo, boulders, paths, grazing_steps] =
      std::move(ground);
  auto surroundings = std::make_shared<const terrain::Surroundings>(
      scene.terrain, terrain, scene.seed, farthest_land_m(scene));
  const scene::Scene half_way = half_way_through(scene);
  const light::Daylight day(half_way.sun, scene.sky);
  const bool large = is_large(scene);
  const auto grid = grid_of_ground(scene, terrain, sketch);
  FactorMap growth = grid ? growth_map(scene, terrain::Surface(terrain, finer.get(), *grid, known))
                          : std::move(growth_of_cells).value();
  std::optional<FactorMap> growth_of_window;
  if (large) growth_of_window = std::move(growth_of_cells);
  std::optional<cloud::Clouds> clouds;
  if (!scene.clouds.empty())
    clouds.emplace(half_way, cloud::Clouds::usual_pixel_m(scene.clouds), season.get());
  auto weather = std::make_shared<const snow::Weather>(scene, season.get());
  std::shared_ptr<const Snow> snow;
  if (scene::may_snow(scene) || scene::may_lie(scene))
    snow = std::make_shared<const Snow>(
        scene, weather, terrain, snow_folder,
        sketch ? sketch->snow_samples : snow::SnowGround::usual_max_samples);
  auto withering = std::make_shared<const Withering>(scene, terrain, season);
  auto mixtures = std::make_shared<const MixtureField>(scene, terrain);
  std::shared_ptr<const wind::AirFlow> air;
  if (grass_waves(scene)) air = air_flow(scene, terrain);
  std::shared_ptr<const wind::AirFlow> over_snow;
  if (scene::may_blow(scene)) over_snow = air_over_snow(scene, terrain);
  Site site{std::move(terrain),
            std::move(finer),
            std::move(water),
            std::move(cover),
            std::move(scree),
            std::move(photo),
            std::move(boulders),
            std::move(paths),
            std::move(grazing_steps),
            std::move(surroundings),
            std::move(growth),
            std::move(growth_of_window),
            day,
            {},
            {},
            {},
            {},
            std::move(clouds),
            std::move(season),
            std::move(weather),
            std::move(withering),
            std::move(mixtures),
            std::move(snow),
            std::move(air),
            std::move(over_snow),
            sketch};
  if (large) site.ledges = ledges(scene, site.snow.get(), site.surface(*grid), site.growth);
  if (!scene::sun_moves(scene)) light_ground(scene, site);
  return site;
}

}  // namespace

Snow::Snow(const scene::Scene& scene, const std::shared_ptr<const snow::Weather>& weather,
           const Heightfield& terrain, const fs::path& folder, int max_samples)
    : pictures(scene.seed),
      ground(
          scene, terrain, [weather](double time_s) { return weather->at(time_s); }, max_samples),
      large(large_cover(
          scene, terrain, [weather](double time_s) { return weather->at(time_s); }, folder)) {}

GroundGrid light_grid(const Heightfield& terrain, const GroundGrid& grid,
                      const std::optional<Sketch>& sketch) {
  constexpr double min_samples = 17.0;
  const double step_m = std::max(grid.step_m(), terrain.step_m());
  double samples = std::ceil(grid.square.size_m / step_m - 1e-9) + 1.0;
  if (sketch) samples = std::min(samples, 1.0 * sketch->light_samples);
  return {grid.square, static_cast<int>(std::max(samples, min_samples))};
}

GroundPart ground_part(const scene::Scene& scene, const Site& site, const GroundGrid& grid,
                       RowParts parts, const terrain::SnowSurface& lying) {
  const terrain::Surface surface = site.surface(grid, std::move(parts), lying);
  GroundPart part = lit_part(scene, site, surface, grid, growth_map(scene, surface));
  part.ledges = ledges(scene, site.snow.get(), surface, part.growth);
  return part;
}

terrain::Surface Site::surface(const GroundGrid& grid, RowParts parts,
                               const terrain::SnowSurface& lying) const {
  return {terrain,
          finer.get(),
          grid,
          {water.get(), cover.get(), scree.get(), photo.get(), boulders.get(), paths.get(),
           grazing_steps.get()},
          std::move(parts),
          lying};
}

terrain::GroundLight light_on(const Site& site, const GroundGrid& grid, RowParts parts,
                              const terrain::SnowSurface& lying) {
  return lit(site, site.surface(grid, std::move(parts), lying), grid);
}

terrain::GroundLight light_in_frame(const scene::Scene& scene, const Site& site, int frame,
                                    const terrain::SnowSurface& lying) {
  const GroundGrid grid = whole_grid(scene);
  const std::vector<View> views = {view_of_frame(scene, site.terrain, frame)};
  const terrain::GroundLight light =
      lit(site, site.surface(grid, rows_seen(grid, site, views, 2.0), lying), grid);
  const RowParts in_view = rows_seen(grid, site, views, 0.0);
  return {filled_up(light.sun, in_view, site.light.sun),
          filled_up(light.sky, in_view, site.light.sky),
          filled_up(light.overcast, in_view, site.light.overcast)};
}

terrain::GroundLight whole_light(const Site& site, const Heightfield& surface,
                                 const terrain::SnowSurface& lying) {
  constexpr double step_m = 0.05;
  constexpr int most = 1025;
  const terrain::LandShadow* shadow = site.land_shadow.get();
  if (site.sketch)
    return terrain::ground_light(surface, site.day, {surface.square(), site.sketch->light_samples},
                                 shadow);
  terrain::GroundLight light = terrain::ground_light(surface, site.day, shadow);
  if (!site.is_uneven() && !lying.carved) return light;
  const GroundGrid grid{surface.square(), std::min(map_samples(surface.size_m(), step_m), most)};
  return site.surface(grid, {}, lying).lit(std::move(light), site.day.sun_direction());
}

const FactorMap& growth_of_cells(const Site& site) {
  return site.growth_of_window ? *site.growth_of_window : site.growth;
}

Site make_site(const scene::Scene& scene, std::shared_ptr<const phenology::FilmSeason> season,
               const fs::path& snow_folder, const std::optional<Sketch>& sketch) {
  if (sketch && !is_large(scene))
    return site_on(scene, scene_ground(scene), std::nullopt, std::move(season), snow_folder,
                   sketch);
  GrowingGround land = growing_ground(scene);
  return site_on(scene, std::move(land.ground), std::move(land.growth_of_cells), std::move(season),
                 snow_folder, sketch);
}

Site make_site(const scene::Scene& scene, GrowingGround land,
               std::shared_ptr<const phenology::FilmSeason> season, const fs::path& snow_folder) {
  return site_on(scene, std::move(land.ground), std::move(land.growth_of_cells), std::move(season),
                 snow_folder, /*sketch=*/{});
}

double visual_range_m(const scene::Scene& scene, const Site& site, int frame) {
  if (!site.season) return scene.sky.visual_range_m;
  return site.season->visual_range_m(scene::season_days(scene, frame));
}

Site site_of_frame(const scene::Scene& scene, const Site& site, int frame) {
  if (!scene::sun_moves(scene)) return site;
  Site now = site;
  scene::Sky sky = scene.sky;
  sky.visual_range_m = visual_range_m(scene, site, frame);
  now.day = light::Daylight(scene::sun_of_frame(scene, frame), sky);
  light_ground(scene, now, frame);
  return now;
}

double leaf_area_index(const scene::Scene& scene) {
  const double patch_m = scene.grass.patch_m;
  return scene::blade_area_m2(scene) / (patch_m * patch_m);
}

}  // namespace wold::place
