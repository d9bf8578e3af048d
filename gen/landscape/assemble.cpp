#include "landscape/assemble.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>

#include "landscape/exposure.h"
#include "landscape/frame_sky.h"
#include "landscape/lit_ground.h"
#include "landscape/snow_in_air.h"
#include "landscape/snowy_air.h"
#include "landscape/snowy_ground.h"
#include "landscape/view.h"
#include "scene/calendar.h"
#include "scene/sun_path.h"
#include "scene/winter.h"

namespace wold::landscape {
namespace {

void add(const CellChoice& choice, int volume, std::vector<Cell>& cells) {
  cells.push_back({choice.world_from_cell, volume, choice.reach});
}

void add(const CellChoice& choice, int mesh, std::vector<BladeCell>& cells) {
  cells.push_back({choice.world_from_cell, mesh});
}

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
    if (choice.blades == blades) add(choice, numbers.at(key(choice)), cells);
}

std::tuple<int, grass::PatchState, int, int> volume_key(const CellChoice& choice) {
  return {choice.variant, choice.state(), choice.turn, choice.level};
}

std::pair<int, grass::PatchState> blades_key(const CellChoice& choice) {
  return {choice.variant, choice.state()};
}

Subject bare_subject(const scene::Scene& scene) {
  return scene.clouds.empty() ? Subject::meadow : Subject::clouds;
}

/// What the camera leaves of how dark it gets in a film in which the sun moves. A season's frames
/// are days apart, and each is exposed anew.
double dusk(const scene::Scene& scene, int frame) {
  if (!scene::sun_moves(scene) || scene::is_season(scene)) return 1.0;
  const auto elevation_deg = [&](double time) { return scene::sun_at(scene, time).elevation_deg; };
  return dusk_gain(elevation_deg(time_of_frame(scene, frame)),
                   std::max(elevation_deg(0.0), elevation_deg(1.0)));
}

/// A film in which it may snow is exposed for snow all through; a season is so long that the camera
/// follows the ground as it whitens, and the `light` on it as clouds and snowfall hide the sun.
double gain(const scene::Scene& scene, const light::Daylight& day, const SnowyGround& ground,
            const ColourMap& light) {
  const double for_bare = metered_gain(day, bare_subject(scene));
  if (scene::is_season(scene))
    return std::lerp(for_bare, snow_gain(day, light), ground.white_share());
  const bool for_snow = scene::may_lie(scene) || scene::may_snow(scene);
  return for_snow ? metered_gain(day, Subject::snow) : for_bare;
}

/// `illuminate`: what clouds and snow make of the light on the ground under a clear sky.
template <class Illuminate>
Daylight open_daylight(const light::Daylight& day, double sun_share, const Illuminate& illuminate) {
  constexpr int samples = 2;
  constexpr Square square{.size_m = 1.0};
  const terrain::GroundLight by_sky{ColourMap(samples, square, glm::vec3(0.0F)),
                                    ColourMap(samples, square, day.sky_irradiance()),
                                    FactorMap(samples, square, 1.0F)};
  return {day.sun_direction(), day.sun_irradiance() * static_cast<float>(sun_share),
          illuminate(by_sky).at(0, 0)};
}

}  // namespace

Landscape assemble(const scene::Scene& scene, const Site& site, int frame,
                   std::span<const CellChoice> choices, const PatchLookup& lookup) {
  Landscape landscape;
  landscape.frame = frame;
  landscape.weathering = scene.ageing.frames.at(static_cast<std::size_t>(frame - 1));
  landscape.time_s = scene::time_s(scene, frame);
  landscape.patch_m = scene.grass.patch_m;
  landscape.camera = resolved_camera(scene.camera, site.terrain, time_of_frame(scene, frame));
  landscape.width_px = scene.render.size_px[0];
  landscape.height_px = scene.render.size_px[1];
  landscape.samples = scene.render.samples;
  landscape.df3_bits = scene.render.df3_bits;
  place(choices, /*blades=*/false, volume_key, lookup.volume, landscape.volumes, landscape.cells);
  place(choices, /*blades=*/true, blades_key, lookup.blades, landscape.blade_meshes,
        landscape.blade_cells);
  const SnowyGround ground(scene, site, frame);
  landscape.terrain = ground.surface();
  const FrameSky sky(scene, site, frame, landscape.camera.eye_m);
  const double overcast_per_m = overcast_extinction_per_m(scene, site, frame);
  const SnowyAir air(site.day, overcast_per_m, ground.mean_albedo());
  const auto illuminate = [&](const terrain::GroundLight& clear) {
    const ColourMap light = sky.light(clear);
    return overcast_per_m > 0.0 ? air.light(light, clear.overcast) : light;
  };
  landscape.daylight = open_daylight(site.day, air.sun_share(), illuminate);
  const ColourMap light = illuminate(ground.light());
  landscape.exposure_gain =
      gain(scene, site.day, ground, light) * dusk(scene, frame) * std::exp2(scene.render.exposure);
  LitGround(scene, site, landscape, choices, lookup.far, illuminate).show(ground, light, landscape);
  sky.show(landscape, overcast_per_m > 0.0);
  if (overcast_per_m > 0.0) let_it_snow(scene, site, air, landscape);
  return landscape;
}

}  // namespace wold::landscape
