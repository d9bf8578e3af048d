#include "work/memory_model.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/elementary.h"
#include "core/ground_map.h"
#include "place/cell_window.h"
#include "place/ground_grids.h"
#include "scene/species.h"
#include "scene/winter.h"
#include "sky/blowing_snow.h"
#include "work/file_sizes.h"

namespace wold::work {
namespace {

constexpr double megabyte = 1e6;
constexpr double thread_bytes = 9.0 * megabyte;  // its stack, mostly

/// The program itself, before it makes anything.
double idle_bytes(const Job& job) { return 100.0 * megabyte + thread_bytes * threads_of(job); }

/// Choosing cells and what is known of each; docs/measurements.md has the table that this follows.
double cells_bytes(const scene::Scene& scene) {
  const double along_a_side = scene.terrain.size_m / scene.grass.patch_m;
  constexpr double max_along_a_side = 320.0;  // of large terrains only what is near
  return 0.16 * megabyte * math::pow(std::min(along_a_side, max_along_a_side), 1.54);
}

/// Painting the ground and what else a frame needs; more where the ground's picture is large.
double painting_bytes(const scene::Scene& scene) {
  constexpr double usual = 120.0 * megabyte, min = 30.0 * megabyte, sample_bytes = 62.0;
  if (place::is_large(scene)) return usual;
  const double along_a_side = place::picture_grid(scene).samples;
  return std::max(usual, min + sample_bytes * along_a_side * along_a_side);
}

/// Maps of what is white on the ground; of a large terrain painting_bytes() has them.
double lying_snow_bytes(const scene::Scene& scene) {
  constexpr double sample_bytes = 8.0;
  if (!scene::may_lie(scene) || place::is_large(scene)) return 0.0;
  const double along_a_side = place::snow_grid(scene).samples;
  return sample_bytes * along_a_side * along_a_side;
}

/// The sky as the camera sees it, where there are clouds or snow in it: a little larger than the
/// picture, in single precision, and its file as it is written.
double backdrop_bytes(const scene::Scene& scene) {
  constexpr double pixel_bytes = 15.0;
  if (scene.clouds.empty() && !scene::may_snow(scene)) return 0.0;
  return pixel_bytes * scene.render.size_px[0] * scene.render.size_px[1];
}

/// Blades and petals of the patches that a frame shows as such.
double drawn_blades(const scene::Scene& scene, const film::FrameDemand& shown) {
  long drawn = 0;
  for (const auto& [variant, state] : shown.patches) drawn += scene::drawn_of(scene, variant);
  return static_cast<double>(drawn);
}

/// What a renderer reads for a frame.
double read_bytes(const scene::Scene& scene, const exporter::MemoryCosts& costs,
                  const film::FrameDemand& shown) {
  double bytes =
      costs.ground_sample * ground_samples(scene, shown) + costs.cloud_voxel * cloud_voxels(scene) +
      costs.haze_voxel * sky::blowing_snow_voxels(scene) +
      costs.terrain_sample * scene.terrain.samples * scene.terrain.samples +
      costs.part * static_cast<double>(shown.parts) + costs.blade * drawn_blades(scene, shown);
  const double voxel_bytes = costs.voxel + density_bytes(scene, costs.density_grids);
  const VolumeSizes sizes(scene);
  for (const film::ShownVolume& volume : shown.volumes) {
    const VolumeSize size = sizes.of(volume.variant, volume.state, volume.lod);
    bytes += voxel_bytes * size.voxels + costs.filled_voxel * size.filled;
  }
  for (const film::ShownVolume& texel : without_turns(shown.volumes))
    bytes += density_bytes(scene, costs.texel_grids) *
             sizes.of(texel.variant, texel.state, texel.lod).voxels;
  return bytes;
}

/// A frame's landscape, before anybody reads a volume of it.
double landscape_bytes(const Job& job) {
  constexpr double cloud_voxel_bytes = 24.0, haze_voxel_bytes = 24.0;
  return idle_bytes(job) + painting_bytes(job.scene) + cells_bytes(job.scene) +
         cloud_voxel_bytes * cloud_voxels(job.scene) +
         haze_voxel_bytes * sky::blowing_snow_voxels(job.scene) + backdrop_bytes(job.scene) +
         lying_snow_bytes(job.scene);
}

void keep_larger(VolumeSize& largest, const VolumeSize& other) {
  largest.voxels = std::max(largest.voxels, other.voxels);
  largest.filled = std::max(largest.filled, other.filled);
}

/// The largest of a scene's volumes, whatever its frames show.
VolumeSize largest_volume(const scene::Scene& scene) {
  const VolumeSizes sizes(scene);
  const std::size_t mixtures = scene::mixtures_of(scene).size();
  VolumeSize largest;
  for (std::size_t mixture = 0; mixture < mixtures; ++mixture)
    keep_larger(largest, sizes.of(static_cast<int>(mixture) * scene.grass.variants, 0, 0));
  return largest;
}

/// The largest of the volumes that a film shows. Where it shows none, what it has of blades and of
/// grass far away is as large as any.
VolumeSize largest_volume(const scene::Scene& scene, const film::FilmDemand& demand) {
  if (demand.volumes().empty()) return largest_volume(scene);
  const VolumeSizes sizes(scene);
  VolumeSize largest;
  for (const film::ShownVolume& volume : demand.volumes())
    keep_larger(largest, sizes.of(volume.variant, volume.state, volume.lod));
  return largest;
}

/// Beside the landscape, the box of a volume, and by the thread what is filled of one in the
/// making.
double scene_memory_bytes(const Job& job, int threads, const VolumeSize& largest) {
  constexpr double voxel_bytes = 20.0, filled_bytes = 130.0;
  return landscape_bytes(job) + voxel_bytes * largest.voxels +
         filled_bytes * threads * largest.filled;
}

}  // namespace

double voxels_of(const scene::Scene& scene) { return math::pow(scene.grass.lods.front(), 3.0); }

double texel_memory_bytes(const Job& job) {
  return idle_bytes(job) + 50.0 * megabyte + 15.0 * voxels_of(job.scene);
}

int scene_threads(const Job& job) {
  int threads = threads_of(job);
  const VolumeSize largest = largest_volume(job.scene);
  if (job.memory_bytes > 0.0)
    while (threads > 1 && scene_memory_bytes(job, threads, largest) > job.memory_bytes) --threads;
  return threads;
}

double cloud_memory_bytes(const Job& job) { return landscape_bytes(job); }

double max_scene_memory_bytes(const Job& job) {
  return scene_memory_bytes(job, scene_threads(job), largest_volume(job.scene));
}

double scene_memory_bytes(const Job& job, const film::FilmDemand& demand) {
  return scene_memory_bytes(job, scene_threads(job), largest_volume(job.scene, demand));
}

double passes_memory_bytes(const Job& job, const film::FilmDemand& demand) {
  constexpr double voxel_bytes = 4.0;     // of every volume that is shown: its density
  constexpr double albedo_bytes = 60.0;   // of one at a time: its albedo, and what that is made of
  constexpr double blade_bytes = 9000.0;  // its triangles, and the boxes they lie in
  constexpr double pixel_bytes = 400.0;
  const VolumeSizes sizes(job.scene);
  double shown_voxels = 0.0, max_voxels = 0.0, blades = 0.0;
  std::set<std::tuple<int, grass::PatchState, int>> known;
  for (const auto& [frame, shown] : demand.frames()) {
    double voxels = 0.0;
    known.clear();
    for (const film::ShownVolume& volume : shown.volumes) {
      if (!known.insert({volume.variant, volume.state, volume.lod}).second) continue;
      const VolumeSize size = sizes.of(volume.variant, volume.state, volume.lod);
      voxels += size.voxels;
      max_voxels = std::max(max_voxels, size.voxels);
    }
    shown_voxels = std::max(shown_voxels, voxels);
    blades = std::max(blades, drawn_blades(job.scene, shown));
  }
  const scene::Render& render = job.scene.render;
  return landscape_bytes(job) + voxel_bytes * shown_voxels + albedo_bytes * max_voxels +
         blade_bytes * blades + pixel_bytes * render.size_px[0] * render.size_px[1];
}

double renderer_memory_bytes(const Job& job, const exporter::MemoryCosts& costs,
                             const film::FrameDemand& shown) {
  return costs.start + thread_bytes * threads_of(job) + read_bytes(job.scene, costs, shown);
}

}  // namespace wold::work
