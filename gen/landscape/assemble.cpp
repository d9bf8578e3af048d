#include "landscape/assemble.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "grass/leaf_colour.h"
#include "landscape/tint.h"
#include "landscape/view.h"
#include "terrain/lighting.h"

namespace wold::landscape {
namespace {

constexpr int sky_width_px = 1024;

using VolumeKey = std::tuple<int, int, int, int>;

VolumeKey key(const CellChoice& choice) {
  return {choice.variant, choice.key_frame, choice.turn, choice.level};
}

/// Each different volume once, in ascending order of its key, and the cells that refer to them.
void place_volumes(std::span<const CellChoice> choices, const VolumeLookup& lookup,
                   Landscape& landscape) {
  std::map<VolumeKey, int> numbers;
  std::map<VolumeKey, const CellChoice*> examples;
  for (const CellChoice& choice : choices) examples.emplace(key(choice), &choice);
  for (const auto& [volume, example] : examples) {
    numbers.emplace(volume, static_cast<int>(landscape.volumes.size()));
    landscape.volumes.push_back(lookup(*example));
  }
  for (const CellChoice& choice : choices)
    landscape.cells.push_back({choice.world_from_cell, numbers.at(key(choice))});
}

/// Mean colour of the meadow's grass by weathering degree.
GrassColour grass_colour(const scene::Scene& scene) {
  return [colour = grass::LeafColour(scene.ageing)](double weathering) {
    return colour(weathering).albedo;
  };
}

/// A white card in the open is exposed above white: grass and sky are dark subjects, and a camera
/// that meters them opens by most of a stop.
constexpr double card_exposure = 1.6;

}  // namespace

Landscape assemble(const scene::Scene& scene, const Heightfield& terrain,
                   const light::Daylight& day, int frame, std::span<const CellChoice> choices,
                   const VolumeLookup& lookup) {
  Landscape landscape;
  landscape.frame = frame;
  landscape.weathering = scene.ageing.frames.at(static_cast<std::size_t>(frame - 1));
  landscape.terrain = terrain;
  landscape.patch_m = scene.grass.patch_m;
  place_volumes(choices, lookup, landscape);
  const ColourMap light = terrain::light_map(terrain, day);
  landscape.light = product(light, weathering_tint(scene, frame, choices, grass_colour(scene)));
  landscape.ground =
      terrain::ground_radiance(light, scene.terrain, scene.seed,
                               glm::vec3(static_cast<float>(canopy_transmittance(scene.grass))));
  landscape.sky = day.sky_image(sky_width_px);
  landscape.camera = resolved_camera(scene.camera, terrain);
  landscape.width_px = scene.render.size_px[0];
  landscape.height_px = scene.render.size_px[1];
  landscape.samples = scene.render.samples;
  landscape.exposure_gain = card_exposure * std::numbers::pi * std::exp2(scene.render.exposure);
  landscape.df3_bits = scene.render.df3_bits;
  return landscape;
}

double canopy_transmittance(const scene::Grass& grass) {
  const double blade_m2 = 0.5 * grass.height_m * grass.width_m;
  const double leaf_area_index = grass.blades * blade_m2 / (grass.patch_m * grass.patch_m);
  constexpr double ross = 0.5;
  constexpr double mean_slant_cosine = 0.5;
  return std::exp(-ross * leaf_area_index / mean_slant_cosine);
}

}  // namespace wold::landscape
