#include "cli/commands.h"
#include "cli/film.h"
#include "cli/job.h"
#include "cli/manifest.h"
#include "cli/output.h"
#include "core/parallel.h"

namespace wold::cli {

ExitCode run_generate(const RenderOptions& options, Progress& progress) {
  const Job job = plan_job(options);
  if (options.dry_run) {
    print_data(summary(job));
    return ExitCode::done;
  }
  const ThreadLimit limit(job.threads);
  Film(job).generate(progress);
  Manifest(job.out).write();
  return ExitCode::done;
}

}  // namespace wold::cli
