#include "work/disk_budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "core/error.h"
#include "work/batches.h"

namespace wold::work {
namespace {

namespace fs = std::filesystem;

double megabytes(double bytes) { return std::ceil(bytes / 1e6); }

}  // namespace

double bytes_at_once(const Job& job, const Stage& stage, std::size_t tasks, const Estimate& each,
                     Work& work) {
  const double all = static_cast<double>(tasks) * each.disk_bytes;
  if (stage != Stage::scenes || job.keep != Keep::pictures) return all;
  return std::min(all, bytes_in_batches(scene_bytes(job, work), tasks));
}

double missing_bytes(const Job& job, const std::vector<StageTasks>& stages, Work& work) {
  double bytes = 0.0;
  for (const StageTasks& stage : stages) {
    const auto missing = std::ranges::count_if(stage.indices, [&](int index) {
      const Task task{stage.stage, index};
      const auto record = work.records().read(task);
      return !record || (record->removed && work.verdict(task).need != Need::no);
    });
    if (missing > 0)
      bytes += bytes_at_once(job, stage.stage, static_cast<std::size_t>(missing),
                             estimate(job, stage, work), work);
  }
  return bytes;
}

std::optional<double> free_bytes(const fs::path& folder) {
  std::error_code error;
  fs::path there = fs::absolute(folder, error);
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  const fs::space_info space = fs::space(there, error);
  if (error) return std::nullopt;
  return static_cast<double>(space.available);
}

void require_disk(const Job& job, const std::vector<StageTasks>& stages) {
  Work work(job);
  const double wanted = missing_bytes(job, stages, work);
  const std::optional<double> free = free_bytes(job.out);
  if (!free || *free >= wanted * 2.0 / 3.0) return;
  throw FileError(fmt::format(
      "no space left for {}: found {:.0f} MB free on its disk, expected about {:.0f} MB for what "
      "is "
      "to be made: free some, name another disk with --out, or take fewer --frames or coarser "
      "grass.levels",
      job.out.string(), megabytes(*free), megabytes(wanted)));
}

}  // namespace wold::work
