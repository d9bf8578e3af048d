#include "cli/commands.h"
#include "cli/disk_budget.h"
#include "cli/do_tasks.h"
#include "cli/folder_lock.h"
#include "cli/memory_budget.h"
#include "cli/output.h"
#include "cli/plan.h"
#include "cli/renderers.h"
#include "cli/scene_warnings.h"
#include "core/file_list.h"
#include "core/files.h"
#include "core/parallel.h"

namespace wold::cli {
namespace {

std::vector<StageTasks> without_pictures(std::vector<StageTasks> stages) {
  std::erase_if(stages, [](const StageTasks& stage) { return makes_pictures(stage.stage); });
  return stages;
}

/// Does what is missing and lists the files.
void complete(const Job& job, const std::vector<StageTasks>& stages, Progress& progress) {
  Renderers renderers(job);
  require_renderers(job, stages, renderers);
  require_memory(job, stages);
  require_disk(job, stages);
  const ThreadLimit limit(job.threads);
  const FolderLock lock(job.out, Access::alone);
  remove_temporaries(job.out);
  remove_empty_folder(job.out / "snow");  // where scratch folders were
  Work work(job, &renderers);
  do_tasks(job, work, stages, progress);
  work.finish();
}

/// What the stages would do, for --dry-run.
void print_plan(const Job& job, bool with_pictures) {
  std::vector<StagePlan> plan = make_plan(job);
  if (!with_pictures)
    std::erase_if(plan, [](const StagePlan& stage) { return makes_pictures(stage.tasks.stage); });
  print_data(plan_text(job, plan, /*why=*/false));
}

}  // namespace

ExitCode run_generate(const RenderOptions& options, Progress& progress) {
  const Job job = plan_job(options);
  print_warnings(job.scene);
  if (options.dry_run)
    print_plan(job, /*with_pictures=*/false);
  else
    complete(job, without_pictures(stages_of(job)), progress);
  return ExitCode::done;
}

ExitCode run_render(const RenderOptions& options, Progress& progress) {
  const Job job = plan_job(options);
  print_warnings(job.scene);
  if (options.dry_run) {
    print_plan(job, /*with_pictures=*/true);
    return ExitCode::done;
  }
  const std::vector<StageTasks> stages = stages_of(job);
  complete(job, stages, progress);
  std::string pictures;
  for (const int frame : job.frames)
    for (const StageTasks& stage : stages)
      if (makes_pictures(stage.stage))
        pictures += picture_path(job, {stage.stage, frame}).string() + "\n";
  print_data(pictures);
  return ExitCode::done;
}

}  // namespace wold::cli
