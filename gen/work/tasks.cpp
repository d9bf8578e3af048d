#include "work/tasks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.h"
#include "scene/species.h"
#include "scene/text.h"

namespace wold::work {
namespace fs = std::filesystem;

std::string_view name_of(const Stage& stage) {
  if (stage.exporter) return stage.exporter->name;
  constexpr std::string_view names[] = {"texels", "clouds", "passes", "scenes"};
  return names[static_cast<std::size_t>(stage.step)];
}

std::string text_of(const Task& task) {
  return fmt::format("{} {}", name_of(task.stage), task.index);
}

std::vector<StageTasks> stages_of(const Job& job) {
  std::vector<StageTasks> stages = {
      {Stage::texels, counted(scene::patch_count(job.scene)), {}, {}}};
  if (!job.scene.clouds.empty()) stages.push_back({Stage::clouds, {1}, {}, {}});
  if (!job.passes.empty()) stages.push_back({Stage::passes, job.frames, Stage::texels, {}});
  if (!job.exporters.empty()) stages.push_back({Stage::scenes, job.frames, Stage::texels, {}});
  if (!job.has_pictures) return stages;
  for (const exporter::Exporter* one : job.exporters)
    if (one->renderer)
      stages.push_back({Stage{Step::pictures, one}, job.frames, {}, Stage::scenes});
  return stages;
}

std::vector<fs::path> folders_of_scene(const Job& job, int frame) {
  std::vector<fs::path> folders;
  for (const exporter::Exporter* one : job.exporters) {
    const fs::path own = one->name;
    folders.push_back(own / "data" / fmt::format("frame_{:04}", frame));
    for (const std::string& shared : one->shared_folders) folders.push_back(own / shared);
  }
  return folders;
}

std::vector<fs::path> folders_written(const Job& job, const Task& task) {
  std::vector<fs::path> folders = {"tasks", "snow", "texels", "clouds", "passes", "logs"};
  if (const exporter::Exporter* shown = task.stage.exporter)
    folders.push_back(fs::path("frames") / shown->name);
  const std::vector<fs::path> of_scene = folders_of_scene(job, task.index);
  folders.insert(folders.end(), of_scene.begin(), of_scene.end());
  return folders;
}

Task find_task(const Job& job, const std::string& stage, int index) {
  std::vector<std::string_view> names;
  for (const StageTasks& tasks : stages_of(job)) {
    names.push_back(name_of(tasks.stage));
    if (names.back() != stage) continue;
    if (std::binary_search(tasks.indices.begin(), tasks.indices.end(), index))
      return {tasks.stage, index};
    throw InputError(fmt::format("found task {} {}, expected one of {}: {}", stage, index, stage,
                                 ranges_text(tasks.indices)));
  }
  throw InputError(fmt::format("found stage {}, expected one of this scene's: {}",
                               scene::in_quotes(stage), fmt::join(names, ", ")));
}

}  // namespace wold::work
