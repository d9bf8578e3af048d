#include "scene/consistency.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wold::scene {
namespace {

/// A rule about several keys: the keys, those to blame first, whether it holds, and what to say.
struct Rule {
  std::vector<std::string> keys;
  bool holds;
  std::string message;
};

/// Patches along a side of the terrain; more cells than this squared no renderer places.
constexpr double most_patches = 2000.0;
/// Soil creep reaches about a metre in steps of a sample: its work grows as samples^4 / size^2, to
/// about 10^10 operations at this limit.
constexpr double most_samples_per_root_m = 376.0;
/// Texels are cubes of voxels in memory; taller ones than this many patches exhaust it.
constexpr double most_patches_high = 4.0;
/// Square metres of leaf per square metre of ground; dense turf has 10.
constexpr double most_leaf_area = 50.0;

Rule inside_terrain(const std::string& key, const std::array<double, 2>& place_m, double size_m) {
  const bool inside =
      place_m[0] >= 0.0 && place_m[0] <= size_m && place_m[1] >= 0.0 && place_m[1] <= size_m;
  return {{key, "terrain.size"},
          inside,
          fmt::format("{}: found [{}, {}] m, expected a place inside the terrain, from 0 to {} m "
                      "(terrain.size)",
                      key, place_m[0], place_m[1], size_m)};
}

Rule looks_somewhere(const Camera& camera) {
  return {{"camera.target", "camera.eye"},
          camera.eye_m != camera.target_m,
          fmt::format("camera.target: found [{}, {}] m, expected another place than camera.eye",
                      camera.target_m[0], camera.target_m[1])};
}

Rule veins_shrink_less(const Ageing& ageing) {
  return {{"ageing.vein_shrinkage", "ageing.mesophyll_shrinkage"},
          ageing.vein_shrinkage < ageing.mesophyll_shrinkage,
          fmt::format("ageing.vein_shrinkage: found {}, expected less than {} "
                      "(ageing.mesophyll_shrinkage): veins shrink less than the tissue around",
                      ageing.vein_shrinkage, ageing.mesophyll_shrinkage)};
}

Rule patch_fits(const Scene& scene) {
  const double size_m = scene.terrain.size_m;
  const double patch_m = scene.grass.patch_m;
  return {{"grass.patch", "terrain.size"},
          patch_m <= size_m && size_m / patch_m <= most_patches,
          fmt::format("grass.patch: found {} m, expected from {} to {} m on a terrain of {} m "
                      "(terrain.size): at most {} patches along a side",
                      patch_m, size_m / most_patches, size_m, size_m, most_patches)};
}

Rule heights_are_coarse_enough(const Terrain& terrain) {
  const int most = static_cast<int>(most_samples_per_root_m * std::sqrt(terrain.size_m));
  return {
      {"terrain.samples", "terrain.size"},
      terrain.samples <= most,
      fmt::format("terrain.samples: found {}, expected at most {} on {} m (terrain.size): finer "
                  "heights take erosion minutes and show no more",
                  terrain.samples, most, terrain.size_m)};
}

Rule blades_fit_the_patch(const Grass& grass) {
  const double tallest_m = grass.height_m * (1.0 + 2.2 * grass.height_spread);
  return {{"grass.height", "grass.patch", "grass.height_spread"},
          tallest_m <= most_patches_high * grass.patch_m,
          fmt::format("grass.height: found {} m, with grass.height_spread up to {} m, expected at "
                      "most {} times grass.patch ({} m)",
                      grass.height_m, tallest_m, most_patches_high, grass.patch_m)};
}

Rule blades_leave_room(const Grass& grass) {
  const double leaf_area =
      0.5 * grass.blades * grass.height_m * grass.width_m / (grass.patch_m * grass.patch_m);
  return {{"grass.blades", "grass.patch", "grass.width", "grass.height"},
          leaf_area <= most_leaf_area,
          fmt::format("grass.blades: found {} blades, {:.0f} m2 of leaf on each m2 of ground, "
                      "expected at most {} m2: fewer or smaller blades, or a larger grass.patch",
                      grass.blades, leaf_area, most_leaf_area)};
}

SourcePosition blamed_place(const Rule& rule, const Places& places) {
  for (const std::string& key : rule.keys)
    if (const auto found = places.given.find(key); found != places.given.end())
      return found->second;
  return {};
}

}  // namespace

void report_contradictions(const Scene& scene, const Places& places,
                           std::vector<Problem>& problems) {
  const std::vector<Rule> rules = {
      patch_fits(scene),
      heights_are_coarse_enough(scene.terrain),
      blades_fit_the_patch(scene.grass),
      blades_leave_room(scene.grass),
      veins_shrink_less(scene.ageing),
      inside_terrain("camera.eye", scene.camera.eye_m, scene.terrain.size_m),
      inside_terrain("camera.target", scene.camera.target_m, scene.terrain.size_m),
      looks_somewhere(scene.camera),
  };
  for (const Rule& rule : rules) {
    const bool judged = std::none_of(rule.keys.begin(), rule.keys.end(),
                                     [&](const auto& key) { return places.failed.count(key) > 0; });
    if (judged && !rule.holds) problems.push_back({blamed_place(rule, places), rule.message});
  }
}

}  // namespace wold::scene
