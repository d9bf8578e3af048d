#include "work/memory_budget.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "core/error.h"
#include "core/machine.h"
#include "work/estimate.h"
#include "work/memory_model.h"

namespace wold::work {
namespace {

/// Of this process while it waits for renderers and looks at their pictures.
double waiting_bytes(const Job& job, std::size_t pictures_at_once) {
  constexpr double more_than_now = 150e6;  // logs, records
  // TBB's, which start when they are wanted, OpenImageIO's, and those that wait.
  constexpr double thread_bytes = 10e6;
  constexpr double bytes_per_pixel = 40.0;
  const double threads =
      threads_of(job) + std::thread::hardware_concurrency() + static_cast<double>(pictures_at_once);
  const double pixels =
      static_cast<double>(job.scene.render.size_px[0]) * job.scene.render.size_px[1];
  return memory_of_process_bytes(::getpid()) + more_than_now + threads * thread_bytes +
         static_cast<double>(pictures_at_once) * pixels * bytes_per_pixel;
}

/// What a task of the stage takes, with the process that waits for its renderer.
double needed_bytes(const Job& job, const StageTasks& stage, Work& work) {
  const double task = memory_bytes(job, stage, work);
  return makes_pictures(stage.stage) ? task + waiting_bytes(job, 1) : task;
}

constexpr double option_m = 1 << 20;  // what M means to --memory

Problem too_little(const Job& job, const Stage& stage, double needed_bytes) {
  Problem problem;
  problem.message = fmt::format(
      "--memory: found {:.0f}M, expected about {:.0f}M for the tasks \"{}\": allow more, or take "
      "coarser grass.levels, fewer grass.variants or fewer --threads",
      job.memory_bytes / option_m, std::ceil(needed_bytes / option_m), name_of(stage));
  return problem;
}

}  // namespace

void require_memory(const Job& job, const std::vector<StageTasks>& stages) {
  if (job.memory_bytes <= 0.0) return;
  Work work(job);
  std::vector<Problem> problems;
  for (const StageTasks& stage : stages)
    if (const double needed = needed_bytes(job, stage, work); needed > job.memory_bytes)
      problems.push_back(too_little(job, stage.stage, needed));
  if (!problems.empty()) throw InputError(problems);
}

std::size_t tasks_within_memory(const Job& job, const StageTasks& stage, Work& work) {
  const double each = memory_bytes(job, stage, work);
  return static_cast<std::size_t>(std::max(1.0, memory_of(job) / each));
}

double memory_for_renderers(const Job& job, std::size_t pictures_at_once) {
  return memory_of(job) - waiting_bytes(job, pictures_at_once);
}

}  // namespace wold::work
