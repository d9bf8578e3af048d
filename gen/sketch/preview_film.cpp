#include "sketch/preview_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/angle.h"
#include "core/parallel.h"
#include "core/progress.h"
#include "film/assemble.h"
#include "film/exporters.h"
#include "meadow/cells.h"
#include "meadow/far_field.h"
#include "meadow/film_lights.h"
#include "place/cell_window.h"
#include "place/view.h"
#include "scene/key_frames.h"
#include "scene/species.h"

namespace wold::sketch {
namespace fs = std::filesystem;
namespace {

constexpr int max_samples = 289;  ///< of terrain and ground, along a side
constexpr int hidden_sky_px = 64;
constexpr double max_blades = 40000.0;  ///< that stand before the camera
constexpr int widest_of_large_px = 176;
constexpr int voxels = 30;  ///< of the texel that far grass is looked up in

/// How low grass looks where so few blades stand nearer to the camera that they can be drawn: a
/// sector of the circle around it.
double standing_pixels(const scene::Scene& scene) {
  const double half_angle = radians(0.5 * scene.camera.field_of_view_deg);
  const double blades_per_m2 = scene.grass.blades / (scene.grass.patch_m * scene.grass.patch_m);
  const double radius_m = std::sqrt(max_blades / blades_per_m2 / half_angle);
  return scene::mean_grass(scene).height_m * place::pixels_per_radian(scene) / radius_m;
}

/// Some of the key frames: between two of them looks are mixed.
std::vector<double> few_key_frames(const scene::Scene& scene) {
  constexpr int max = 9;
  const std::vector<double> all = scene::key_frames(scene);
  std::vector<double> few;
  for (const int key : some_of(static_cast<int>(all.size()), max))
    few.push_back(all[static_cast<std::size_t>(key)]);
  return few;
}

/// Light is smooth where grass scatters it, but mountains cast sharper shadows; snow lies smoothly.
place::Sketch sketch_of(const scene::Scene& scene) {
  constexpr int smooth_samples = 97;
  return {.ground_samples = max_samples,
          .light_samples = place::is_large(scene) ? max_samples : smooth_samples,
          .lean_light_samples = 97,
          .snow_samples = 129};
}

/// The first patch of the mixture that most of the cells have, which are one at least.
int usual_patch(const scene::Scene& scene, std::span<const meadow::CellChoice> cells) {
  std::map<int, int> cells_of_mixture;
  for (const meadow::CellChoice& cell : cells)
    ++cells_of_mixture[scene::mixture_number(scene, cell.variant)];
  const auto most =
      std::max_element(cells_of_mixture.begin(), cells_of_mixture.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return scene::patch_number(scene, most->first, 0);
}

}  // namespace

std::vector<int> some_of(int count, int max) {
  const int steps = max - 1, number = std::min(count, max);
  std::vector<int> some;
  some.reserve(static_cast<std::size_t>(number));
  for (int i = 0; i < number; ++i)  // to the nearest, halves down
    some.push_back(count <= max ? i : (2 * i * (count - 1) + steps - 1) / (2 * steps));
  return some;
}

scene::Scene simplified(scene::Scene scene, int width_px) {
  // The pictures of a large terrain's ground are as fine as the camera's picture.
  if (place::is_large(scene)) width_px = std::min(width_px, widest_of_large_px);
  const double aspect = static_cast<double>(scene.render.size_px[1]) / scene.render.size_px[0];
  scene.render.size_px = {width_px, std::max(1, static_cast<int>(std::lround(aspect * width_px)))};
  scene.render.grass = scene::GrassForm::blades;
  scene.terrain.samples = std::min(scene.terrain.samples, max_samples);
  scene.grass.lods = {voxels};
  scene.grass.key_frames = few_key_frames(scene);
  scene.grass.variants = std::min(scene.grass.variants, 2);
  scene.grass.far_field_below_pixels =
      std::max(scene.grass.far_field_below_pixels, standing_pixels(scene));
  for (scene::CloudLayer& layer : scene.clouds) layer.body = scene::CloudBody::sheet;
  return scene;
}

PreviewFilm::PreviewFilm(const scene::Scene& scene,
                         std::shared_ptr<const phenology::FilmSeason> season,
                         const std::vector<int>& frames, const fs::path& scratch)
    : scene_(scene),
      site_(place::make_site(scene, std::move(season), scratch / "snow", sketch_of(scene))),
      texels_(scene, meadow::film_lights(scene, site_), scratch / "texels") {
  for (const int frame : frames) {
    const meadow::FrameGrass grass = meadow::frame_grass(scene, site_, frame);
    const double snow = grass::PatchState::level_of(grass.snow);
    moments_.emplace(frame, Moment{site_, grass, static_cast<int>(std::lround(snow)),
                                   static_cast<int>(std::lround(grass.light))});
  }
  // Making texels leaves threads idle.
  parallel_for(1 + frames.size(), [&](std::size_t i) {
    if (i == 0) {
      make_looks(frames);
    } else {
      make_site(frames[i - 1], /*with_sky=*/i == 1);
    }
  });
}

void PreviewFilm::make_site(int frame, bool with_sky) {
  place::Site& site = moments_.at(frame).site;
  site = place::site_of_frame(scene_, site_, frame);
  if (!with_sky) site.sketch->sky_width_px = hidden_sky_px;
}

void PreviewFilm::make_looks(const std::vector<int>& frames) {
  grass::TexelDemand demand;
  for (const int frame : frames)
    for (const grass::PatchState& state :
         meadow::far_states(scene_, *site_.withering, moments_.at(frame).grass))
      for (const int mixture : site_.mixtures->present())
        demand[scene::patch_number(scene_, mixture, 0)][moments_.at(frame).at(state.key_frame)][0] =
            {0};
  SilentProgress silent;
  texels_.generate(demand, silent);
  for (const auto& [variant, states] : demand)
    for (const auto& [state, lods] : states)
      looks_.emplace(std::pair(scene::mixture_number(scene_, variant), state),
                     far_appearance(variant, state));
}

meadow::PatchAppearance PreviewFilm::far_appearance(int variant,
                                                    const grass::PatchState& state) const {
  landscape::Volume volume;
  volume.vdb = texels_.volume_path(variant, state, 0);
  volume.emission_grid = "emission_q0";
  volume.voxels = {voxels, voxels, texels_.lod_shape(0).height};
  volume.voxel_m = scene_.grass.patch_m / voxels;
  constexpr int starts = 8;
  return meadow::PatchAppearance(std::span(&volume, 1), starts);
}

Tubes PreviewFilm::blades(int variant, const grass::PatchState& state) const {
  constexpr double pixels_of_shadows = 96.0;  // along a patch
  return texels_.blades(variant, state, scene_.grass.patch_m / pixels_of_shadows);
}

/// Those of the cells that are not there yet.
void PreviewFilm::make_meshes(std::span<const meadow::CellChoice> cells) {
  std::set<std::pair<int, grass::PatchState>> missing;
  for (const meadow::CellChoice& cell : cells)
    if (!meshes_.contains({cell.variant, cell.state()}))
      missing.insert({cell.variant, cell.state()});
  std::vector<landscape::BladeMesh*> meshes;
  meshes.reserve(missing.size());
  for (const auto& key : missing) meshes.push_back(&meshes_[key]);
  const std::vector<std::pair<int, grass::PatchState>> keys(missing.begin(), missing.end());
  parallel_for(keys.size(), [&](std::size_t i) {
    const auto& [variant, state] = keys[i];
    *meshes[i] = {fmt::format("v{}_{}", variant, state.name()),
                  std::make_shared<const Tubes>(blades(variant, state))};
  });
}

landscape::Landscape PreviewFilm::landscape(int frame) {
  const Moment& moment = moments_.at(frame);
  const place::Site& site = moment.site;
  auto cells = meadow::choose_cells(scene_, site.terrain, place::growth_of_cells(site),
                                    *site.mixtures, *site.withering, moment.grass);
  for (meadow::CellChoice& cell : cells) {
    cell.snow = moment.snow;
    cell.light = moment.light;
  }
  make_meshes(cells);
  if (!cells.empty()) usual_patch_ = usual_patch(scene_, cells);
  return film::assemble(scene_, site, moment.grass, cells,
                        {{},
                         [&](const meadow::CellChoice& cell) {
                           return meshes_.at({cell.variant, cell.state()});
                         },
                         [&](int mixture, const grass::PatchState& state) {
                           return looks_.at({mixture, moment.at(state.key_frame)});
                         }},
                        film::needs_of({}));
}

}  // namespace wold::sketch
