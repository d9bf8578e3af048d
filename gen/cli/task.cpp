#include "cli/commands.h"
#include "cli/do_tasks.h"
#include "cli/folder_lock.h"
#include "cli/memory_budget.h"
#include "cli/renderers.h"
#include "core/parallel.h"

namespace wold::cli {

ExitCode run_task(const RenderOptions& options, const std::string& stage, int index,
                  Progress& progress) {
  const Job job = plan_job(options);
  const Task task = find_task(job, stage, index);
  const std::vector<StageTasks> stages = {{task.stage, {task.index}, {}, {}}};
  Renderers renderers(job);
  require_renderers(job, stages, renderers);
  require_memory(job, stages);
  const ThreadLimit limit(job.threads);
  const FolderLock lock(job.out, Access::shared);
  Work work(job, &renderers);
  do_tasks(job, work, stages, progress);
  return ExitCode::done;
}

}  // namespace wold::cli
