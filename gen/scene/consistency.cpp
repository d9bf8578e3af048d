#include "scene/consistency.h"

#include <fmt/format.h>

#include <algorithm>

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
