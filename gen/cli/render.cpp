#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/warnings.h"
#include "console/output.h"
#include "work/complete_job.h"
#include "work/made_files.h"
#include "work/plan.h"

namespace wold::cli {
namespace {

/// What the stages would do, for --dry-run.
void print_plan(const work::Job& job, bool json) {
  const std::vector<work::StagePlan> plan = work::make_plan(job);
  console::print_data(json ? work::plan_json(job, plan)
                           : work::plan_text(job, plan, /*why=*/false));
}

void print_made(const work::Job& job, const std::vector<work::StageTasks>& stages, bool json) {
  console::print_data(json ? work::made_json(job, stages) : work::made_text(job, stages));
}

/// Of files without pictures.
void say_who_has_no_renderer(const work::Job& job, Progress& progress) {
  for (const exporter::Exporter* one : job.exporters)
    if (!one->renderer)
      progress.say(fmt::format("{} has no renderer here; its files are in {}", one->display_name,
                               (job.out / one->name).string()));
}

}  // namespace

ExitCode run_generate(const work::RenderOptions& options, Progress& progress) {
  work::Job job = work::plan_job(options);
  job.has_pictures = false;
  print_warnings(job.text_warnings);
  print_warnings(job.scene, job.season.get());
  if (options.dry_run) {
    print_plan(job, options.json);
    return ExitCode::done;
  }
  const std::vector<work::StageTasks> stages = work::stages_of(job);
  work::complete_job(job, stages, progress);
  if (options.json) console::print_data(work::made_json(job, stages));
  return ExitCode::done;
}

ExitCode run_render(const work::RenderOptions& options, Progress& progress) {
  const work::Job job = work::plan_job(options);
  print_warnings(job.text_warnings);
  print_warnings(job.scene, job.season.get());
  if (options.dry_run) {
    print_plan(job, options.json);
    return ExitCode::done;
  }
  const std::vector<work::StageTasks> stages = work::stages_of(job);
  work::complete_job(job, stages, progress);
  say_who_has_no_renderer(job, progress);
  print_made(job, stages, options.json);
  return ExitCode::done;
}

ExitCode run_passes(const work::RenderOptions& options, Progress& progress) {
  work::RenderOptions with_passes = options;
  if (with_passes.passes.empty()) with_passes.passes = "all";
  work::Job job = work::plan_job(with_passes);
  job.exporters.clear();
  print_warnings(job.text_warnings);
  if (options.dry_run) {
    print_plan(job, options.json);
    return ExitCode::done;
  }
  const std::vector<work::StageTasks> stages = work::stages_of(job);
  work::complete_job(job, stages, progress);
  print_made(job, stages, options.json);
  return ExitCode::done;
}

}  // namespace wold::cli
