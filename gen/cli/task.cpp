#include "cli/commands.h"
#include "core/parallel.h"
#include "film/machine_check.h"
#include "work/do_tasks.h"
#include "work/folder_lock.h"
#include "work/memory_budget.h"
#include "work/own_folder.h"
#include "work/renderers.h"

namespace wold::cli {

ExitCode run_task(const work::RenderOptions& options, const std::string& stage, int index,
                  Progress& progress) {
  const work::Job job = work::plan_job(options);
  const work::Task task = work::find_task(job, stage, index);
  const std::vector<work::StageTasks> stages = {{task.stage, {task.index}, {}, {}}};
  film::require_texel_memory(job.scene, job.places);
  work::Renderers renderers(job, progress);
  work::require_renderers(job, stages, renderers);
  work::require_memory(job, stages);
  const ThreadLimit limit(job.threads);
  work::require_no_way_out(job.out, work::folders_written(job, task));
  const work::FolderLock lock(job.out, work::Access::shared, progress);
  work::Work work(job, &renderers);
  work::do_tasks(job, work, stages, progress);
  return ExitCode::done;
}

}  // namespace wold::cli
