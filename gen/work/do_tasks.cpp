#include "work/do_tasks.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "core/at_once.h"
#include "core/machine.h"
#include "core/parallel.h"
#include "work/batches.h"
#include "work/estimate.h"
#include "work/memory_budget.h"
#include "work/memory_model.h"
#include "work/task_progress.h"

namespace wold::work {
namespace {

std::vector<Task> needed(Work& work, const StageTasks& stage) {
  std::vector<Task> tasks;
  for (const int index : stage.indices)
    if (const Task task{stage.stage, index}; work.verdict(task).need != Need::no)
      tasks.push_back(task);
  return tasks;
}

/// A part of a film that is done by itself.
struct Part {
  std::string name = "";     ///< ", batch 3 of 25" in headings; empty: the whole
  bool is_followed = false;  ///< by one whose scene files are made, too
};

/// Runs tasks under one heading; `in_order(count, body)` calls the body for each.
template <class InOrder>
void run_all(Work& work, const std::vector<Task>& tasks, const std::string& heading,
             const RendererLimits& limits, Progress& progress, const InOrder& in_order) {
  if (tasks.empty()) return;
  work.prepare(tasks.front().stage, progress);
  progress.begin(heading, tasks.size() * TaskProgress::units);
  in_order(tasks.size(), [&](std::size_t i) {
    TaskProgress part(progress, text_of(tasks[i]));
    work.run(tasks[i], limits, part);
    part.finish();
  });
  progress.end();
}

void one_by_one(std::size_t count, const std::function<void(std::size_t)>& body) {
  run_at_once(count, 1, body);
}

/// Texels are made with all threads together; those of several variants at once fill them better.
void make_texels(const Job& job, Work& work, const StageTasks& stage,
                 const std::vector<Task>& tasks, Progress& progress) {
  const std::size_t at_once = tasks_within_memory(job, stage, work);
  run_all(work, tasks, "texels", {}, progress,
          [&](std::size_t count, const std::function<void(std::size_t)>& body) {
            for (std::size_t first = 0; first < count; first += at_once)
              parallel_for(std::min(at_once, count - first),
                           [&](std::size_t i) { body(first + i); });
          });
}

std::size_t pictures_by_threads(const Job& job) {
  // Reading the scene takes a renderer one thread, and small pictures do not fill many.
  constexpr int threads_each = 4;
  return static_cast<std::size_t>(std::max(1, threads_of(job) / threads_each));
}

std::size_t pictures_at_once(const Job& job, double bytes_each) {
  const auto by_threads = static_cast<double>(pictures_by_threads(job));
  const double by_memory = memory_for_renderers(job, 1) / bytes_each;
  return static_cast<std::size_t>(std::max(1.0, std::min(by_threads, by_memory)));
}

/// What each of so many renderers may take; what is left is this process's.
RendererLimits renderer_limits(const Job& job, std::size_t at_once) {
  RendererLimits limits;
  limits.threads = at_once > 1 ? threads_of(job) / static_cast<int>(at_once) : job.threads;
  if (job.memory_bytes <= 0.0) return limits;
  const double renderers = memory_for_renderers(job, at_once);
  limits.memory_bytes = renderers / static_cast<double>(at_once);
  limit_own_memory(job.memory_bytes - renderers);
  return limits;
}

/// Whether as many renderers as there are threads for fit beside what scene files are made with.
bool fit_beside_film(const Job& job, std::size_t pictures, double bytes_each) {
  const std::size_t at_once = std::min(pictures, pictures_by_threads(job));
  return job.memory_bytes <= 0.0 &&
         memory_for_renderers(job, at_once) >= static_cast<double>(at_once) * bytes_each;
}

void make_pictures(const Job& job, Work& work, std::vector<Task> tasks, double bytes_each,
                   const Part& part, Progress& progress) {
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const Task& a, const Task& b) { return a.index < b.index; });
  if (tasks.empty()) return;
  if (!part.is_followed || !fit_beside_film(job, tasks.size(), bytes_each)) work.forget_film();
  const std::size_t at_once = std::min(tasks.size(), pictures_at_once(job, bytes_each));
  run_all(work, tasks, "pictures" + part.name, renderer_limits(job, at_once), progress,
          [&](std::size_t count, const std::function<void(std::size_t)>& body) {
            run_at_once(count, at_once, body);
          });
}

/// Stage by stage, pictures of all renderers together.
void do_stages(const Job& job, Work& work, const std::vector<StageTasks>& stages, const Part& part,
               Progress& progress) {
  if (job.memory_bytes > 0.0) limit_own_memory(job.memory_bytes);
  std::vector<Task> pictures;
  for (const StageTasks& stage : stages) {
    const std::vector<Task> tasks = needed(work, stage);
    if (makes_pictures(stage.stage)) {
      pictures.insert(pictures.end(), tasks.begin(), tasks.end());
    } else if (stage.stage == Stage::texels) {
      make_texels(job, work, stage, tasks, progress);
    } else {
      const ThreadLimit limit(scene_threads(job));
      run_all(work, tasks, std::string(name_of(stage.stage)) + part.name, {}, progress, one_by_one);
    }
  }
  double bytes_each = 1.0;
  if (pictures.size() > 1 || part.is_followed)
    for (const StageTasks& stage : stages)
      if (makes_pictures(stage.stage))
        bytes_each = std::max(bytes_each, memory_bytes(job, stage, work));
  make_pictures(job, work, pictures, bytes_each, part, progress);
}

/// Those of the stages' tasks that `is_wanted`, without stages of which nothing is.
std::vector<StageTasks> of_stages(std::vector<StageTasks> stages,
                                  const std::function<bool(const Task&)>& is_wanted) {
  for (StageTasks& stage : stages)
    std::erase_if(stage.indices, [&](int index) { return !is_wanted({stage.stage, index}); });
  std::erase_if(stages, [](const StageTasks& stage) { return stage.indices.empty(); });
  return stages;
}

/// Frames of which something is to be done.
std::vector<int> frames_to_do(Work& work, const std::vector<StageTasks>& stages) {
  std::set<int> frames;
  for (const StageTasks& stage : stages)
    for (const Task& task : needed(work, stage)) frames.insert(task.index);
  return {frames.begin(), frames.end()};
}

/// What all scene files are made from first, then they and their pictures, batch by batch.
void do_in_batches(const Job& job, Work& work, const std::vector<StageTasks>& stages,
                   Progress& progress) {
  const auto of_step = [&](Step first, Step last) {
    return of_stages(stages, [&](const Task& task) {
      return first <= task.stage.step && task.stage.step <= last;
    });
  };
  do_stages(job, work, of_step(Step::texels, Step::passes), {}, progress);
  work.remove_scenes(job.frames);
  const std::vector<StageTasks> scenes = of_step(Step::scenes, Step::scenes);
  const std::vector<StageTasks> pictures = of_step(Step::pictures, Step::pictures);
  const std::vector<int> to_do = frames_to_do(work, of_step(Step::scenes, Step::pictures));
  if (to_do.empty()) return;
  const auto batches = batches_of(to_do, scene_bytes(job, work).own);
  for (std::size_t i = 0; i < batches.size(); ++i) {
    const auto is_in_batch = [&](const Task& task) {
      return std::ranges::binary_search(batches[i], task.index);
    };
    const std::string name =
        batches.size() > 1 ? fmt::format(", batch {} of {}", i + 1, batches.size()) : "";
    const Part part{name, i + 1 < batches.size()};
    do_stages(job, work, of_stages(scenes, is_in_batch), part, progress);
    if (i > 0) work.remove_scenes(batches[i - 1]);
    do_stages(job, work, of_stages(pictures, is_in_batch), part, progress);
  }
  work.remove_scenes(batches.back());
}

bool has_pictures_to_make(Work& work, const StageTasks& stage) {
  return makes_pictures(stage.stage) && std::ranges::any_of(stage.indices, [&](int index) {
           return work.verdict({stage.stage, index}).need != Need::no;
         });
}

}  // namespace

void require_renderers(const Job& job, const std::vector<StageTasks>& stages,
                       Renderers& renderers) {
  Work work(job);
  std::vector<const exporter::Exporter*> wanted;
  for (const StageTasks& stage : stages)
    if (has_pictures_to_make(work, stage)) wanted.push_back(stage.stage.exporter);
  renderers.require(wanted);
}

void do_tasks(const Job& job, Work& work, const std::vector<StageTasks>& stages,
              Progress& progress) {
  if (job.keep == Keep::pictures)
    do_in_batches(job, work, stages, progress);
  else
    do_stages(job, work, stages, {}, progress);
}

}  // namespace wold::work
