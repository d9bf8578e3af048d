#include "cli/do_tasks.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/estimate.h"
#include "cli/task_progress.h"
#include "core/at_once.h"
#include "core/parallel.h"

namespace wold::cli {
namespace {

std::vector<Task> needed(Work& work, const StageTasks& stage) {
  std::vector<Task> tasks;
  for (const int index : stage.indices)
    if (const Task task{stage.stage, index}; work.verdict(task).need != Need::no)
      tasks.push_back(task);
  return tasks;
}

/// Runs tasks under one heading; `in_order(count, body)` calls the body for each.
template <class InOrder>
void run_all(Work& work, const std::vector<Task>& tasks, const std::string& heading, int threads,
             Progress& progress, const InOrder& in_order) {
  if (tasks.empty()) return;
  work.prepare(tasks.front().stage, progress);
  progress.begin(heading, tasks.size() * TaskProgress::units);
  in_order(tasks.size(), [&](std::size_t i) {
    TaskProgress share(progress, text_of(tasks[i]));
    work.run(tasks[i], threads, share);
    share.finish();
  });
  progress.end();
}

void one_by_one(std::size_t count, const std::function<void(std::size_t)>& body) {
  run_at_once(count, 1, body);
}

std::size_t pictures_at_once(const Job& job, double bytes_each) {
  // Reading the scene takes a renderer one thread, and small pictures do not fill many.
  constexpr int threads_each = 4;
  const double by_memory = job.memory_bytes / bytes_each;
  return static_cast<std::size_t>(
      std::max(1.0, std::min<double>(threads_of(job) / threads_each, by_memory)));
}

void make_pictures(const Job& job, Work& work, std::vector<Task> tasks, double bytes_each,
                   Progress& progress) {
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const Task& a, const Task& b) { return a.index < b.index; });
  const std::size_t at_once = std::min(tasks.size(), pictures_at_once(job, bytes_each));
  const int threads = at_once > 1 ? threads_of(job) / static_cast<int>(at_once) : job.threads;
  run_all(work, tasks, "pictures", threads, progress,
          [&](std::size_t count, const std::function<void(std::size_t)>& body) {
            run_at_once(count, at_once, body);
          });
}

}  // namespace

void do_tasks(const Job& job, Work& work, const std::vector<StageTasks>& stages,
              Progress& progress) {
  std::vector<Task> pictures;
  double bytes_each = 1.0;
  for (const StageTasks& stage : stages) {
    const std::vector<Task> tasks = needed(work, stage);
    const std::string heading(name_of(stage.stage));
    if (makes_pictures(stage.stage)) {
      pictures.insert(pictures.end(), tasks.begin(), tasks.end());
      bytes_each = std::max(bytes_each, estimate(job, stage, work).memory_bytes);
    } else if (stage.stage == Stage::texels) {
      run_all(work, tasks, heading, job.threads, progress, parallel_for);
    } else {
      run_all(work, tasks, heading, job.threads, progress, one_by_one);
    }
  }
  make_pictures(job, work, pictures, bytes_each, progress);
}

}  // namespace wold::cli
