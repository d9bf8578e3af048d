#include "cli/estimate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/memory_model.h"
#include "scene/key_frames.h"

namespace wold::cli {
namespace {

// For one thread, from what README.md says of examples/mountain.toml on 2 processors: right within
// a factor of two or three for scenes like that.
constexpr double texel_seconds = 4e-7;           // per voxel of the finest level's cube
constexpr double texel_bytes = 1.0;              // likewise, of all levels and turns on disk
constexpr double scene_seconds = 10.0;           // per frame: light, ground, sky and their files
constexpr double scene_bytes = 1.2e7;            // per frame and renderer, without shared volumes
constexpr double renderer_start_seconds = 5.0;   // reading the scene
constexpr double blender_seconds = 20.0;         // per megapixel and sample
constexpr double povray_seconds = 70.0;          // per megapixel and root of samples: they adapt
constexpr double picture_bytes_per_pixel = 2.0;  // of a PNG

Estimate texels(const Job& job) {
  const double voxels = voxels_of(job.scene);
  const auto states =
      static_cast<double>(std::min(job.frames.size() + 1, scene::key_frames(job.scene).size()));
  return {states * voxels * texel_seconds, texel_memory_bytes(job), states * voxels * texel_bytes};
}

Estimate picture(const Job& job, Stage stage) {
  const scene::Render& render = job.scene.render;
  const double pixels = static_cast<double>(render.size_px[0]) * render.size_px[1];
  const double work = stage == Stage::blender ? blender_seconds * render.samples
                                              : povray_seconds * std::sqrt(render.samples);
  return {renderer_start_seconds + work * pixels / 1e6,
          renderer_memory_bytes(job, stage, guessed_files(job.scene, stage)),
          pixels * picture_bytes_per_pixel};
}

/// For one thread.
Estimate modelled(const Job& job, Stage stage) {
  switch (stage) {
    case Stage::texels:
      return texels(job);
    case Stage::clouds:
      return {10.0, scene_memory_bytes(job), 1e7 * static_cast<double>(job.scene.clouds.size())};
    case Stage::scenes:
      return {scene_seconds, scene_memory_bytes(job),
              scene_bytes * static_cast<double>(wanted_renderers(job.scene).size())};
    default:
      return picture(job, stage);
  }
}

/// The records of the first tasks that have been done.
std::vector<TaskRecord> records_of(Stage stage, const std::vector<int>& indices, const Work& work) {
  constexpr std::size_t enough = 16;
  constexpr std::size_t most_looked_at = 1000;
  std::vector<TaskRecord> records;
  for (std::size_t i = 0; i < std::min(indices.size(), most_looked_at); ++i)
    if (auto record = work.records().read({stage, indices[i]});
        record && record->facts == work.scene_hash()) {
      records.push_back(std::move(*record));
      if (records.size() == enough) break;
    }
  return records;
}

/// Seconds and disk are means, memory the most. Files that tasks share count for each.
std::optional<Estimate> measured(const StageTasks& stage, const Work& work) {
  const std::vector<TaskRecord> records = records_of(stage.stage, stage.indices, work);
  if (records.empty()) return std::nullopt;
  Estimate result;
  for (const TaskRecord& record : records) {
    result.seconds += record.seconds;
    result.memory_bytes = std::max(result.memory_bytes, record.memory_bytes);
    for (const auto& output : record.outputs)
      result.disk_bytes += static_cast<double>(output.second.bytes);
  }
  result.seconds /= static_cast<double>(records.size());
  result.disk_bytes /= static_cast<double>(records.size());
  result.measured = true;
  return result;
}

/// From the scene files of the frames, as far as they have been made; 0 when there are none.
double memory_by_files_bytes(const Job& job, const StageTasks& stage, const Work& work) {
  double most = 0.0;
  for (const TaskRecord& record : records_of(Stage::scenes, stage.indices, work))
    most = std::max(
        most, renderer_memory_bytes(job, stage.stage, files_of(record, name_of(stage.stage))));
  return most;
}

}  // namespace

Estimate estimate(const Job& job, const StageTasks& stage, const Work& work) {
  Estimate result = modelled(job, stage.stage);
  result.seconds /= threads_of(job);
  if (const auto known = measured(stage, work)) {
    result.seconds = known->seconds;
    result.disk_bytes = known->disk_bytes;
    result.measured = true;
    if (known->memory_bytes > 0.0) result.memory_bytes = known->memory_bytes;
  } else if (makes_pictures(stage.stage)) {
    const double by_files = memory_by_files_bytes(job, stage, work);
    if (by_files > 0.0) result.memory_bytes = by_files;
  }
  return result;
}

}  // namespace wold::cli
