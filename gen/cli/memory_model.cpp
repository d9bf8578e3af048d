#include "cli/memory_model.h"

#include <algorithm>
#include <cmath>

#include "landscape/cell_window.h"
#include "landscape/ground_grids.h"

namespace wold::cli {
namespace {

constexpr double megabyte = 1e6;
constexpr double thread_bytes = 9.0 * megabyte;  // its stack, mostly

/// The program itself, before it makes anything.
double idle_bytes(const Job& job) { return 100.0 * megabyte + thread_bytes * threads_of(job); }

/// Choosing cells and what is known of each; README.md has the table that this follows.
double cells_bytes(const scene::Scene& scene) {
  const double along_a_side = scene.terrain.size_m / scene.grass.patch_m;
  constexpr double most_along_a_side = 320.0;  // of large terrains only what is near
  return 0.18 * megabyte * std::pow(std::min(along_a_side, most_along_a_side), 1.54);
}

double ground_samples(const scene::Scene& scene) {
  return static_cast<double>(scene.terrain.samples) * scene.terrain.samples;
}

/// Painting the ground and what else a frame needs; more where the ground's picture is large.
double painting_bytes(const scene::Scene& scene) {
  constexpr double usual = 100.0 * megabyte, least = 30.0 * megabyte, sample_bytes = 47.0;
  if (landscape::is_large(scene)) return usual;
  const double along_a_side = landscape::picture_grid(scene).samples;
  return std::max(usual, least + sample_bytes * along_a_side * along_a_side);
}

double blender_bytes(const SceneFiles& files) {
  return 64.0 * files.volume_bytes + 120.0 * files.cell_bytes;
}

double povray_bytes(const SceneFiles& files) {
  return 0.85 * files.volume_bytes + 6.0 * files.cell_bytes + 30.0 * files.part_bytes;
}

double scene_memory_bytes(const Job& job, int threads) {
  return idle_bytes(job) + painting_bytes(job.scene) + cells_bytes(job.scene) +
         (20.0 + 16.0 * threads) * voxels_of(job.scene);
}

}  // namespace

double voxels_of(const scene::Scene& scene) { return std::pow(scene.grass.levels.front(), 3.0); }

double texel_memory_bytes(const Job& job) {
  return idle_bytes(job) + 50.0 * megabyte + 15.0 * voxels_of(job.scene);
}

int scene_threads(const Job& job) {
  int threads = threads_of(job);
  if (job.memory_bytes > 0.0)
    while (threads > 1 && scene_memory_bytes(job, threads) > job.memory_bytes) --threads;
  return threads;
}

double scene_memory_bytes(const Job& job) { return scene_memory_bytes(job, scene_threads(job)); }

SceneFiles files_of(const TaskRecord& scenes, std::string_view renderer) {
  SceneFiles files;
  for (const auto& [name, state] : scenes.outputs) {
    if (!name.starts_with(renderer)) continue;
    const auto bytes = static_cast<double>(state.bytes);
    if (name.ends_with(".vdb") || name.ends_with(".df3")) files.volume_bytes += bytes;
    if (name.ends_with(".f32") || name.ends_with(".inc")) files.cell_bytes += bytes;
    if (name.ends_with("/cells.inc")) files.part_bytes += bytes;
  }
  return files;
}

SceneFiles guessed_files(const scene::Scene& scene, Stage stage) {
  constexpr double states = 1.25;  // of a variant, that one picture shows
  const double voxels = states * scene.grass.variants * voxels_of(scene);
  return stage == Stage::blender ? SceneFiles{0.54 * voxels, 9.0 * ground_samples(scene), 0.0}
                                 : SceneFiles{3.3 * voxels, 100.0 * ground_samples(scene), 0.0};
}

double renderer_memory_bytes(const Job& job, Stage stage, const SceneFiles& files) {
  const double start = (stage == Stage::blender ? 830.0 : 200.0) * megabyte;
  return start + thread_bytes * threads_of(job) +
         (stage == Stage::blender ? blender_bytes(files) : povray_bytes(files));
}

}  // namespace wold::cli
