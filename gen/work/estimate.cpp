#include "work/estimate.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "film/exporters.h"
#include "film/film_demand.h"
#include "place/cell_window.h"
#include "scene/winter.h"
#include "work/file_sizes.h"
#include "work/memory_model.h"

namespace wold::work {
namespace {

// For one thread, from runs of examples/ on 2 processors: right within a factor of two for scenes
// like those.
constexpr double texel_seconds = 5e-8;          // per voxel of the finest level and state
constexpr double patch_seconds = 0.08;          // per patch and state: its blades
constexpr double scene_seconds = 10.0;          // per frame: cells, light, sky
constexpr double lying_snow_seconds = 6.0;      // more where snow may lie
constexpr double sample_seconds = 1e-6;         // per sample of the ground's pictures
constexpr double large_sample_seconds = 7e-6;   // with relief below the model's cells, and horizons
constexpr double scene_file_seconds = 2e-9;     // per byte that is written
constexpr double pass_pixel_seconds = 5e-5;     // per pixel: its rays through the grass
constexpr double cloud_seconds = 10.0;          // per layer
constexpr double renderer_start_seconds = 5.0;  // reading the scene

/// A share of what all tasks of a stage take.
double each(double all, const StageTasks& stage) {
  return all / static_cast<double>(stage.indices.size());
}

Estimate texels(const Job& job, const StageTasks& stage, const film::FilmDemand& demand) {
  std::set<film::BladePatchState> unlit;
  for (const film::ShownVolume& volume : demand.volumes())
    unlit.insert({volume.variant, volume.state.unlit()});
  const double seconds =
      (patch_seconds + texel_seconds * voxels_of(job.scene)) * static_cast<double>(unlit.size());
  return {each(seconds, stage), texel_memory_bytes(job),
          each(texel_bytes(job.scene, demand, film::reads_unlit_texels(job)), stage)};
}

double ground_seconds(const scene::Scene& scene) {
  return (place::is_large(scene) ? large_sample_seconds : sample_seconds) * ground_samples(scene);
}

/// A frame's landscape, before anything is written.
double landscape_seconds(const scene::Scene& scene) {
  const double snow_seconds = scene::may_lie(scene) ? lying_snow_seconds : 0.0;
  return scene_seconds + snow_seconds + ground_seconds(scene);
}

SceneBytes scene_bytes_of(const Job& job, const film::FilmDemand& demand) {
  SceneBytes all;
  for (const exporter::Exporter* one : job.exporters) {
    const SceneBytes bytes = scene_bytes(job.scene, one->files, demand);
    all.shared += bytes.shared;
    all.own += bytes.own;
  }
  return all;
}

Estimate scenes(const Job& job, const StageTasks& stage, const film::FilmDemand& demand) {
  const double bytes = scene_bytes_of(job, demand).of(stage.indices.size());
  const double seconds = landscape_seconds(job.scene) + scene_file_seconds * each(bytes, stage);
  return {seconds, scene_memory_bytes(job, demand), each(bytes, stage)};
}

Estimate passes_of_frame(const Job& job, const film::FilmDemand& demand) {
  const scene::Render& render = job.scene.render;
  const double pixels = static_cast<double>(render.size_px[0]) * render.size_px[1];
  return {landscape_seconds(job.scene) + pass_pixel_seconds * pixels,
          passes_memory_bytes(job, demand), pass_bytes(job.scene, job.passes)};
}

/// Of the frame that takes most.
double picture_memory_bytes(const Job& job, const Stage& stage, const film::FilmDemand& demand) {
  double max = 0.0;
  for (const auto& [frame, shown] : demand.frames())
    max = std::max(max, renderer_memory_bytes(job, stage.exporter->memory, shown));
  return max;
}

Estimate picture(const Job& job, const StageTasks& stage, const film::FilmDemand& demand) {
  const scene::Render& render = job.scene.render;
  const double pixels = static_cast<double>(render.size_px[0]) * render.size_px[1];
  const double work = stage.stage.exporter->seconds_per_megapixel(render.samples);
  return {renderer_start_seconds + work * pixels / 1e6,
          picture_memory_bytes(job, stage.stage, demand), picture_bytes(job.scene)};
}

/// For one thread.
Estimate modelled(const Job& job, const StageTasks& stage, const film::FilmDemand& demand) {
  switch (stage.stage.step) {
    case Step::texels:
      return texels(job, stage, demand);
    case Step::clouds:
      return {cloud_seconds * static_cast<double>(job.scene.clouds.size()), cloud_memory_bytes(job),
              cloud_picture_bytes(job.scene)};
    case Step::passes:
      return passes_of_frame(job, demand);
    case Step::scenes:
      return scenes(job, stage, demand);
    case Step::pictures:
      return picture(job, stage, demand);
  }
  return {};
}

/// The records of the first tasks that have been done.
std::vector<TaskRecord> records_of(const Stage& stage, const std::vector<int>& indices,
                                   const Work& work) {
  constexpr std::size_t enough = 16;
  constexpr std::size_t max_sampled = 1000;
  std::vector<TaskRecord> records;
  for (std::size_t i = 0; i < std::min(indices.size(), max_sampled); ++i)
    if (auto record = work.records().read({stage, indices[i]});
        record && record->facts == work.scene_hash()) {
      records.push_back(std::move(*record));
      if (records.size() == enough) break;
    }
  return records;
}

/// Seconds and disk are means, memory the most. Files that tasks share count once.
std::optional<Estimate> measured(const StageTasks& stage, const Work& work) {
  const std::vector<TaskRecord> records = records_of(stage.stage, stage.indices, work);
  if (records.empty()) return std::nullopt;
  Estimate result;
  std::map<std::string, double> files;
  for (const TaskRecord& record : records) {
    result.seconds += record.seconds;
    result.memory_bytes = std::max(result.memory_bytes, record.memory_bytes);
    for (const auto& [name, state] : record.outputs) files[name] = static_cast<double>(state.bytes);
  }
  for (const auto& [name, bytes] : files) result.disk_bytes += bytes;
  result.seconds /= static_cast<double>(records.size());
  result.disk_bytes /= static_cast<double>(records.size());
  result.measured = true;
  return result;
}

}  // namespace

Estimate estimate(const Job& job, const StageTasks& stage, Work& work) {
  Estimate result = modelled(job, stage, work.demand());
  result.seconds /= threads_of(job);
  if (const auto known = measured(stage, work)) {
    result.seconds = known->seconds;
    result.disk_bytes = known->disk_bytes;
    result.measured = true;
    if (known->memory_bytes > 0.0) result.memory_bytes = known->memory_bytes;
  }
  return result;
}

SceneBytes scene_bytes(const Job& job, Work& work) { return scene_bytes_of(job, work.demand()); }

double memory_bytes(const Job& job, const StageTasks& stage, Work& work) {
  if (stage.stage == Stage::texels) return texel_memory_bytes(job);
  if (stage.stage == Stage::passes) return passes_memory_bytes(job, work.demand());
  if (!makes_pictures(stage.stage)) return max_scene_memory_bytes(job);
  if (const auto known = measured(stage, work); known && known->memory_bytes > 0.0)
    return known->memory_bytes;
  return picture_memory_bytes(job, stage.stage, work.demand());
}

}  // namespace wold::work
