#include "cli/estimate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/key_frames.h"

namespace wold::cli {
namespace {

// For one thread, from what README.md says of examples/mountain.toml on 2 processors: right within
// a factor of two or three for scenes like that.
constexpr double gigabyte = 1e9;
constexpr double texel_seconds = 4e-7;       // per voxel of the finest level's cube
constexpr double texel_bytes = 1.0;          // likewise, of all levels and turns on disk
constexpr double texel_memory_bytes = 30.0;  // likewise
constexpr double scene_seconds = 10.0;       // per frame: light, ground, sky and their files
constexpr double scene_memory_bytes = 1.0 * gigabyte;
constexpr double scene_bytes = 1.2e7;           // per frame and renderer, without shared volumes
constexpr double renderer_start_seconds = 5.0;  // reading the scene
constexpr double blender_seconds = 20.0;        // per megapixel and sample
constexpr double povray_seconds = 70.0;         // per megapixel and root of samples: they adapt
constexpr double blender_memory_bytes = 1.5 * gigabyte;
constexpr double povray_memory_bytes = 1.0 * gigabyte;
constexpr double picture_bytes_per_pixel = 2.0;  // of a PNG

Estimate texels(const Job& job) {
  const double voxels = std::pow(job.scene.grass.levels.front(), 3.0);
  const auto states =
      static_cast<double>(std::min(job.frames.size() + 1, scene::key_frames(job.scene).size()));
  return {states * voxels * texel_seconds, voxels * texel_memory_bytes,
          states * voxels * texel_bytes};
}

Estimate picture(const Job& job, Stage stage) {
  const scene::Render& render = job.scene.render;
  const double pixels = static_cast<double>(render.size_px[0]) * render.size_px[1];
  const double work = stage == Stage::blender ? blender_seconds * render.samples
                                              : povray_seconds * std::sqrt(render.samples);
  return {renderer_start_seconds + work * pixels / 1e6,
          stage == Stage::blender ? blender_memory_bytes : povray_memory_bytes,
          pixels * picture_bytes_per_pixel};
}

/// For one thread.
Estimate modelled(const Job& job, Stage stage) {
  switch (stage) {
    case Stage::texels:
      return texels(job);
    case Stage::clouds:
      return {10.0, scene_memory_bytes, 1e7 * static_cast<double>(job.scene.clouds.size())};
    case Stage::scenes:
      return {scene_seconds, scene_memory_bytes,
              scene_bytes * static_cast<double>(wanted_renderers(job.scene).size())};
    default:
      return picture(job, stage);
  }
}

/// The mean of the first tasks that have been done. Files that tasks share count for each.
std::optional<Estimate> measured(const StageTasks& stage, const Work& work) {
  constexpr int enough = 16;
  constexpr std::size_t most_looked_at = 1000;
  Estimate sum;
  int count = 0;
  for (std::size_t i = 0; i < std::min(stage.indices.size(), most_looked_at) && count < enough; ++i)
    if (const auto record = work.records().read({stage.stage, stage.indices[i]});
        record && record->facts == work.scene_hash()) {
      ++count;
      sum.seconds += record->seconds;
      for (const auto& output : record->outputs)
        sum.disk_bytes += static_cast<double>(output.second.bytes);
    }
  if (count == 0) return std::nullopt;
  return Estimate{sum.seconds / count, 0.0, sum.disk_bytes / count, true};
}

}  // namespace

Estimate estimate(const Job& job, const StageTasks& stage, const Work& work) {
  Estimate result = modelled(job, stage.stage);
  result.seconds /= threads_of(job);
  if (const auto known = measured(stage, work)) {
    result.seconds = known->seconds;
    result.disk_bytes = known->disk_bytes;
    result.measured = true;
  }
  return result;
}

}  // namespace wold::cli
