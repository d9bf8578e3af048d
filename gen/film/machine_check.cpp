#include "film/machine_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <thread>

#include "core/machine.h"
#include "scene/species.h"
#include "scene/text.h"

namespace wold::film {
namespace {

using scene::Rule;

/// What making a texel takes at its peak, measured: bytes for each point drawn and for each voxel
/// that is kept, and how many of these a point makes where blades are few.
constexpr double bytes_per_point = 120.0;
constexpr double bytes_per_voxel = 250.0;
constexpr double voxels_per_point = 3.0;

/// `keys`: the one that has the path first.
Rule file_exists(const std::vector<std::string>& keys, const std::string& path) {
  std::error_code error;
  return {keys, path.empty() || std::filesystem::is_regular_file(path, error),
          fmt::format("{}: found {}, expected a file that is there", keys.front(),
                      scene::in_quotes(path))};
}

/// The pictures of a layer of clouds, from 0.
void add_textures(const scene::Scene& scene, std::size_t layer, std::vector<Rule>& rules) {
  const std::string item = scene::item_name("clouds", layer);
  for (const std::string& path : scene.clouds[layer].textures)
    rules.push_back(file_exists({item + ".textures", item}, path));
}

/// Points drawn of a patch: grass.points_per_voxel_face of them per voxel's face of leaf, of which
/// a cone shows pi / 8 of height times width on average.
double points_of_patch(const scene::Scene& scene) {
  const scene::Grass& grass = scene.grass;
  const double leaf_m2 = std::numbers::pi / 4.0 * scene::max_blade_area_m2(scene);
  const double voxel_m = grass.patch_m / grass.lods.front();
  return grass.points_per_voxel_face * leaf_m2 / (voxel_m * voxel_m);
}

Rule texels_fit_in_memory(const scene::Scene& scene) {
  const scene::Grass& grass = scene.grass;
  const double side = grass.lods.front();
  double highest_m = 0.0;
  for (const scene::Species& species : scene::species_of(scene))
    highest_m = std::max(highest_m, scene::max_standing_m(species.plant));
  const double height_voxels = std::ceil(highest_m / grass.patch_m * side);
  const double points = points_of_patch(scene);
  const double voxels = std::min(voxels_per_point * points, side * side * height_voxels);
  const int threads = scene.render.threads > 0
                          ? scene.render.threads
                          : static_cast<int>(std::thread::hardware_concurrency());
  const int at_once = std::clamp(threads, 1, scene::patch_count(scene));
  const double needed_gb = at_once * (bytes_per_point * points + bytes_per_voxel * voxels) / 1e9;
  const double memory_gb = machine_memory_bytes() / 1e9;
  return {{"grass.levels", "grass.points_per_voxel_face", "grass.blades", "grass.variants",
           "render.threads"},
          needed_gb <= memory_gb,
          fmt::format(
              "grass.levels: found {} voxels along a side and {:.2g} points in a patch, "
              "which for {} patches at once need {:.1f} GB of memory, expected at most the "
              "{:.1f} GB of this machine: coarser levels, a smaller grass.points_per_voxel_face, "
              "fewer grass.blades or fewer render.threads",
              side, points, at_once, needed_gb, memory_gb)};
}

void require(const std::vector<Rule>& rules, const scene::Places& places) {
  std::vector<Problem> problems;
  scene::report_broken(rules, places, problems);
  scene::throw_problems(std::move(problems));
}

}  // namespace

void require_files(const scene::Scene& scene, const scene::Places& places) {
  std::vector<Rule> rules = {
      file_exists({"terrain.elevation"}, scene.terrain.elevation),
      file_exists({"terrain.surroundings"}, scene.terrain.surroundings),
      file_exists({"terrain.cover"}, scene.terrain.cover),
      file_exists({"terrain.photo"}, scene.terrain.photo),
      file_exists({"growth.mask"}, scene.growth.mask),
      file_exists({"grass.from_texel"}, scene.grass.from_texel),
      file_exists({"weather.table"}, scene.weather.table),
      file_exists({"season.table"}, scene.season.table),
  };
  for (std::size_t item = 0; item < scene.species.size(); ++item)
    rules.push_back(file_exists({scene::item_name("species", item) + ".mask"},
                                scene.species[item].habitat.mask));
  for (std::size_t layer = 0; layer < scene.clouds.size(); ++layer)
    add_textures(scene, layer, rules);
  require(rules, places);
}

void require_texel_memory(const scene::Scene& scene, const scene::Places& places) {
  require({texels_fit_in_memory(scene)}, places);
}

}  // namespace wold::film
