#include "landscape/assemble.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "grass/blade_patch.h"
#include "grass/fibres.h"
#include "landscape/canopy_snow.h"
#include "landscape/cell_window.h"
#include "landscape/combed_light.h"
#include "landscape/exposure.h"
#include "landscape/far_field.h"
#include "landscape/film_lighting.h"
#include "landscape/frame_sky.h"
#include "landscape/ground_grids.h"
#include "landscape/haze.h"
#include "landscape/snow_in_air.h"
#include "landscape/snowy_air.h"
#include "landscape/snowy_ground.h"
#include "landscape/tint.h"
#include "landscape/view.h"
#include "scene/winter.h"

namespace wold::landscape {
namespace {

/// Each different patch once, in ascending order of `key`, and the cells that refer to them.
template <class Key, class Lookup, class Patch, class Instance>
void place(std::span<const CellChoice> choices, bool blades, const Key& key, const Lookup& lookup,
           std::vector<Patch>& patches, std::vector<Instance>& cells) {
  using Value = std::invoke_result_t<Key, const CellChoice&>;
  std::map<Value, int> numbers;
  std::map<Value, const CellChoice*> examples;
  for (const CellChoice& choice : choices)
    if (choice.blades == blades) examples.emplace(key(choice), &choice);
  for (const auto& [value, example] : examples) {
    numbers[value] = static_cast<int>(patches.size());
    patches.push_back(lookup(*example));
  }
  for (const CellChoice& choice : choices)
    if (choice.blades == blades) cells.push_back({choice.world_from_cell, numbers.at(key(choice))});
}

std::tuple<int, grass::PatchState, int, int> volume_key(const CellChoice& choice) {
  return {choice.variant, choice.state(), choice.turn, choice.level};
}

std::pair<int, grass::PatchState> blades_key(const CellChoice& choice) {
  return {choice.variant, choice.state()};
}

/// Mean colour of the meadow's grass by weathering degree, under `snow` and what the cells show.
GrassColour grass_colour(const grass::WitheringPatch& patch, const grass::AgeingModel& model,
                         double snow, std::span<const CellChoice> choices) {
  constexpr int steps = 64;
  std::map<double, std::vector<glm::vec3>> colours = {{snow, {}}};
  for (const CellChoice& choice : choices) colours[choice.state().snow_share()];
  for (auto& [share, by_weathering] : colours)
    for (int i = 0; i <= steps; ++i)
      by_weathering.push_back(
          grass::mean_albedo(patch.at(static_cast<double>(i) / steps, share), model));
  return [colours](double weathering, double share) {
    const std::vector<glm::vec3>& by_weathering = colours.at(share);
    const double place = std::clamp(weathering, 0.0, 1.0) * steps;
    const auto i = std::min(static_cast<std::size_t>(place), std::size_t{steps - 1});
    return glm::mix(by_weathering[i], by_weathering[i + 1],
                    static_cast<float>(place - static_cast<double>(i)));
  };
}

/// What combing does to the light of the frame's grass.
CombedLight combed_light(const scene::Scene& scene, const Site& site,
                         const grass::BladePatch& patch, const grass::AgeingModel& model) {
  constexpr int fibres = 150;
  return {grass::representative_fibres(patch, model, fibres), film_lighting(scene, site),
          static_cast<float>(scene.grass.gloss)};
}

/// The grid of what combing does, on a part of the ground of a large terrain: it costs much.
GroundGrid combed_grid(const GroundGrid& grid) {
  constexpr int most = 513;
  return {grid.square, std::min(grid.samples, most)};
}

std::map<grass::PatchState, PatchLook> far_looks(const scene::Scene& scene, int frame,
                                                 const PatchLookup& lookup) {
  std::map<grass::PatchState, PatchLook> looks;
  for (const grass::PatchState& state : far_states(scene, frame))
    looks.emplace(state, PatchLook(lookup.far(state)));
  return looks;
}

Subject subject_of(const scene::Scene& scene) {
  if (scene::may_lie(scene) || scene::may_snow(scene)) return Subject::snow;
  return scene.clouds.empty() ? Subject::meadow : Subject::clouds;
}

/// The frame's light on ground that has some light under a clear sky.
using Illuminate = std::function<ColourMap(const terrain::GroundLight& clear)>;

/// Light on the grass, how much of it stands, and the ground with what is painted on it.
void set_ground(Landscape& landscape, const scene::Scene& scene, const Site& site,
                std::span<const CellChoice> choices, const SnowyGround& ground,
                const Illuminate& illuminate, const PatchLookup& lookup) {
  const int frame = landscape.frame;
  const View view(landscape.camera, landscape.width_px, landscape.height_px);
  const grass::AgeingModel model(scene.ageing, scene.grass.specular);
  const grass::WitheringPatch patch(scene, model, /*variant=*/0);
  const double snow = canopy_snow(scene, frame);
  const CombedLight combed = combed_light(scene, site, patch.at(landscape.weathering, snow), model);
  const bool large = is_large(scene);
  const auto on_grass = [&](const ColourMap& light, const GroundGrid& grid) {
    const Combing combing(scene);
    return product(light,
                   large ? combed_light_map(combed, combing, site.terrain, view, combed_grid(grid))
                         : combed_light_map(combed, combing, site.terrain, view));
  };
  const Haze haze(site.day, landscape.camera.eye_m, scene.sky.visual_range_m);
  std::optional<Meadow> meadow;  // as it looks from afar
  if (shows_distance(scene, site, landscape.camera))
    meadow.emplace(scene, site.terrain, view, frame, far_looks(scene, frame, lookup));
  const auto paint = [&](ColourMap& picture, const FactorMap& growth,
                         const ColourMap& grass_light) {
    if (!meadow) return;
    paint_far_grass(picture, scene, site.terrain, growth, grass_light, view, *meadow);
    veil_ground(picture, site.terrain, view, haze);
  };

  const ColourMap light = illuminate(ground.light());
  ColourMap grass_light = on_grass(light, whole_grid(scene));
  landscape.ground = product(ground.reflectance(), light);
  paint(landscape.ground, ground.growth(), grass_light);
  for (const GroundGrid& grid : detail_grids(scene, landscape.camera)) {
    const GroundPart part = ground.covered(ground_part(scene, site.terrain, site.day, grid));
    const ColourMap light_there = illuminate(part.light);
    ColourMap picture = product(part.reflectance, light_there);
    paint(picture, part.growth, on_grass(light_there, grid));
    landscape.ground_details.push_back(
        {std::move(picture).at_corner(glm::dvec2(0.0)), grid.square.corner_m});
  }
  if (large) {
    const GroundGrid window = window_grid(scene);
    const GroundGrid coarser = light_grid(site.terrain, window);
    grass_light =
        on_grass(illuminate(terrain::ground_light(site.terrain, site.day, coarser)), window);
  }
  landscape.light = product(
      grass_light,
      weathering_tint(scene, frame, choices, snow, grass_colour(patch, model, snow, choices)));
  landscape.standing = standing_grass(scene, site.terrain, growth_of_cells(site), view);
  if (meadow)
    landscape.light =
        product(landscape.light, veil_of_grass(grass_light, site.terrain, view, *meadow, haze));
}

}  // namespace

bool shows_distance(const scene::Scene& scene, const Site& site, const Camera& camera) {
  const View view(camera, scene.render.size_px[0], scene.render.size_px[1]);
  return has_far_field(scene, site.terrain, view) ||
         Haze(site.day, camera.eye_m, scene.sky.visual_range_m).is_visible(site.terrain);
}

Landscape assemble(const scene::Scene& scene, const Site& site, int frame,
                   std::span<const CellChoice> choices, const PatchLookup& lookup) {
  Landscape landscape;
  landscape.frame = frame;
  landscape.weathering = scene.ageing.frames.at(static_cast<std::size_t>(frame - 1));
  landscape.patch_m = scene.grass.patch_m;
  landscape.camera = resolved_camera(scene.camera, site.terrain, time_of_frame(scene, frame));
  landscape.width_px = scene.render.size_px[0];
  landscape.height_px = scene.render.size_px[1];
  landscape.samples = scene.render.samples;
  landscape.df3_bits = scene.render.df3_bits;
  landscape.exposure_gain =
      metered_gain(site.day, subject_of(scene)) * std::exp2(scene.render.exposure);
  place(choices, /*blades=*/false, volume_key, lookup.volume, landscape.volumes, landscape.cells);
  place(choices, /*blades=*/true, blades_key, lookup.blades, landscape.blade_meshes,
        landscape.blade_cells);
  const SnowyGround ground(scene, site, frame);
  landscape.terrain = ground.surface();
  const FrameSky sky(scene, site, frame, landscape.camera.eye_m);
  const double snow_per_m = snow_extinction_per_m(scene, site, frame);
  const SnowyAir air(site.day, snow_per_m, ground.mean_albedo());
  const auto illuminate = [&](const terrain::GroundLight& clear) {
    const ColourMap light = sky.light(clear);
    return snow_per_m > 0.0 ? air.light(light, clear.overcast) : light;
  };
  set_ground(landscape, scene, site, choices, ground, illuminate, lookup);
  sky.show(landscape, snow_per_m > 0.0);
  if (snow_per_m > 0.0) let_it_snow(scene, site, air, landscape);
  return landscape;
}

}  // namespace wold::landscape
