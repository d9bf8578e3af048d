#include "landscape/assemble.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <type_traits>
#include <utility>

#include "cloud/shadow.h"
#include "core/colour.h"
#include "grass/blade_patch.h"
#include "grass/fibres.h"
#include "landscape/cloud_boxes.h"
#include "landscape/cloudy_sky.h"
#include "landscape/combed_light.h"
#include "landscape/far_field.h"
#include "landscape/haze.h"
#include "landscape/tint.h"
#include "landscape/view.h"

namespace wold::landscape {
namespace {

constexpr int sky_width_px = 1024;

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

std::tuple<int, int, int, int> volume_key(const CellChoice& choice) {
  return {choice.variant, choice.key_frame, choice.turn, choice.level};
}

std::pair<int, int> blades_key(const CellChoice& choice) {
  return {choice.variant, choice.key_frame};
}

/// Mean colour of the meadow's grass by weathering degree.
GrassColour grass_colour(const grass::WitheringPatch& patch, const grass::AgeingModel& model) {
  constexpr int steps = 64;
  std::vector<glm::vec3> colours;
  for (int i = 0; i <= steps; ++i)
    colours.push_back(grass::mean_albedo(patch.at(static_cast<double>(i) / steps), model));
  return [colours](double weathering) {
    const double place = std::clamp(weathering, 0.0, 1.0) * steps;
    const auto i = std::min(static_cast<std::size_t>(place), std::size_t{steps - 1});
    return glm::mix(colours[i], colours[i + 1], static_cast<float>(place - static_cast<double>(i)));
  };
}

/// What combing does to the light of the frame's grass.
FactorMap combed_light(const scene::Scene& scene, const Site& site, const View& view,
                       const grass::BladePatch& patch, const grass::AgeingModel& model) {
  constexpr int fibres = 150;
  const CombedLight light(grass::representative_fibres(patch, model, fibres),
                          grass::make_lighting(site.day, film_eye_direction(scene, site.terrain)),
                          static_cast<float>(scene.grass.gloss));
  return combed_light_map(light, Combing(scene), site.terrain, view);
}

std::optional<cloud::CloudState> clouds_of(const Site& site, int frame) {
  if (!site.clouds) return std::nullopt;
  return site.clouds->at_frame(frame);
}

/// The light on the ground under clouds, which stand before the sun and change the sky.
ColourMap clouded_light(const Site& site, const cloud::CloudState& clouds, const CloudySky& sky) {
  const FactorMap sun_share =
      cloud::sun_share(clouds, site.terrain, site.day.sun_direction(), site.light.sun.samples());
  ColourMap light = product(site.light.sun, sun_share);
  const glm::vec3 sky_factor = sky.irradiance() / site.day.sky_irradiance();
  for (std::size_t i = 0; i < light.values().size(); ++i)
    light.values()[i] += site.light.sky.values()[i] * sky_factor;
  return light;
}

/// A distance from the camera that no ground and no cloud reaches.
double beyond_everything_m(const Landscape& landscape) {
  double size_m = landscape.terrain.size_m() + 2.0 * std::abs(landscape.camera.eye_m.z) + 100.0;
  for (const CloudBox& box : landscape.clouds)
    size_m = std::max(size_m, box.voxels.x * box.voxel_m + box.corner_m.z);
  return 2.0 * size_m;
}

/// What of the clouds is volume, and the rest as the camera sees it.
void set_clouds(Landscape& landscape, const scene::Scene& scene, const Site& site,
                const cloud::CloudState& clouds) {
  const Camera& camera = landscape.camera;
  const double visual_range_m = scene.sky.visual_range_m;
  const auto windows = cloud_windows(clouds, camera);
  landscape.clouds = cloud_boxes(clouds, windows, site.day, camera.eye_m, visual_range_m);
  const CloudySky behind(site.day, clouds, camera.eye_m, visual_range_m, windows);
  landscape.backdrop = sky_backdrop(behind, camera, landscape.width_px, landscape.height_px,
                                    beyond_everything_m(landscape));
}

std::map<int, PatchLook> far_looks(const scene::Scene& scene, int frame,
                                   const PatchLookup& lookup) {
  std::map<int, PatchLook> looks;
  for (const int key_frame : far_key_frames(scene, frame))
    looks.emplace(key_frame, PatchLook(lookup.far(key_frame)));
  return looks;
}

/// A white card in the open is exposed above white: grass and sky are dark subjects, and a camera
/// that meters them opens by most of a stop.
constexpr double card_exposure = 1.6;

/// The same under clouds, which are white cards themselves.
constexpr double card_exposure_clouds = 1.2;

/// Exposure of the sky at 20 degrees of elevation at which it is about to burn out: there the
/// camera stops opening. A low sun lights the sky more than the ground.
constexpr double brightest_sky = 0.9;

/// Factor on every radiance as a camera's meter sets it.
double metered_gain(const light::Daylight& day, bool clouds) {
  constexpr double elevation_rad = 20.0 * std::numbers::pi / 180.0;
  const double sky = luminance(day.mean_sky_radiance(elevation_rad));
  return std::min((clouds ? card_exposure_clouds : card_exposure) * std::numbers::pi,
                  brightest_sky / sky);
}

}  // namespace

bool shows_distance(const scene::Scene& scene, const Site& site, const Camera& camera) {
  const View view(camera, scene.render.size_px[0], scene.render.size_px[1]);
  return has_far_field(scene, site.terrain, view) ||
         Haze(site.day, camera.eye_m, scene.sky.visual_range_m).is_visible(site.terrain);
}

Landscape assemble(const scene::Scene& scene, const Site& site, int frame,
                   std::span<const CellChoice> choices, const PatchLookup& lookup) {
  const Heightfield& terrain = site.terrain;
  Landscape landscape;
  landscape.frame = frame;
  landscape.weathering = scene.ageing.frames.at(static_cast<std::size_t>(frame - 1));
  landscape.terrain = terrain;
  landscape.patch_m = scene.grass.patch_m;
  landscape.camera = resolved_camera(scene.camera, terrain, time_of_frame(scene, frame));
  landscape.width_px = scene.render.size_px[0];
  landscape.height_px = scene.render.size_px[1];
  const View view(landscape.camera, landscape.width_px, landscape.height_px);
  place(choices, /*blades=*/false, volume_key, lookup.volume, landscape.volumes, landscape.cells);
  place(choices, /*blades=*/true, blades_key, lookup.blades, landscape.blade_meshes,
        landscape.blade_cells);
  const grass::AgeingModel model(scene.ageing, scene.grass.specular);
  const grass::WitheringPatch patch(scene, model, /*variant=*/0);
  const std::optional<cloud::CloudState> clouds = clouds_of(site, frame);
  const CloudySky sky(site.day, clouds.value_or(cloud::CloudState{}), landscape.camera.eye_m,
                      scene.sky.visual_range_m);
  const ColourMap light = clouds ? clouded_light(site, *clouds, sky) : site.light.together();
  const ColourMap grass_light =
      product(light, combed_light(scene, site, view, patch.at(landscape.weathering), model));
  landscape.light =
      product(grass_light, weathering_tint(scene, frame, choices, grass_colour(patch, model)));
  landscape.standing = standing_grass(scene, terrain, site.growth, view);
  landscape.ground = product(site.ground_reflectance, light);
  if (shows_distance(scene, site, landscape.camera)) {
    const Haze haze(site.day, landscape.camera.eye_m, scene.sky.visual_range_m);
    const Meadow meadow(scene, terrain, view, frame, far_looks(scene, frame, lookup));
    paint_far_grass(landscape.ground, scene, terrain, site.growth, grass_light, view, meadow);
    veil_ground(landscape.ground, terrain, view, haze);
    landscape.light =
        product(landscape.light, veil_of_grass(grass_light, terrain, view, meadow, haze));
  }
  landscape.sky = clouds ? sky_picture(sky, sky_width_px) : site.day.sky_image(sky_width_px);
  if (clouds) set_clouds(landscape, scene, site, *clouds);
  landscape.samples = scene.render.samples;
  landscape.exposure_gain =
      metered_gain(site.day, clouds.has_value()) * std::exp2(scene.render.exposure);
  landscape.df3_bits = scene.render.df3_bits;
  return landscape;
}

}  // namespace wold::landscape
