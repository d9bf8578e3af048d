#include "work/complete_job.h"

#include "core/file_list.h"
#include "core/files.h"
#include "core/parallel.h"
#include "film/machine_check.h"
#include "work/disk_budget.h"
#include "work/do_tasks.h"
#include "work/folder_lock.h"
#include "work/memory_budget.h"
#include "work/renderers.h"

namespace wold::work {

void complete_job(const Job& job, const std::vector<StageTasks>& stages, Progress& progress) {
  film::require_texel_memory(job.scene, job.places);
  Renderers renderers(job, progress);
  require_renderers(job, stages, renderers);
  require_memory(job, stages);
  require_disk(job, stages);
  const ThreadLimit limit(job.threads);
  const FolderLock lock(job.out, Access::alone, progress);
  remove_temporaries(job.out);
  remove_empty_folder(job.out / "snow");  // where scratch folders were
  Work work(job, &renderers);
  do_tasks(job, work, stages, progress);
  if (job.keep != Keep::all) work.remove_texels();
  work.finish();
}

}  // namespace wold::work
