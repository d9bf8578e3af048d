#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/warnings.h"
#include "console/output.h"
#include "work/complete_job.h"
#include "work/plan.h"

namespace wold::cli {
namespace {

std::vector<work::StageTasks> without_pictures(std::vector<work::StageTasks> stages) {
  std::erase_if(stages, [](const work::StageTasks& stage) { return makes_pictures(stage.stage); });
  return stages;
}

std::string pass_files(const work::Job& job) {
  std::string files;
  if (!job.passes.empty())
    for (const int frame : job.frames) files += work::passes_path(job, frame).string() + "\n";
  return files;
}

/// What the stages would do, for --dry-run.
void print_plan(const work::Job& job, bool with_pictures) {
  std::vector<work::StagePlan> plan = work::make_plan(job);
  if (!with_pictures)
    std::erase_if(plan,
                  [](const work::StagePlan& stage) { return makes_pictures(stage.tasks.stage); });
  console::print_data(work::plan_text(job, plan, /*why=*/false));
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
  const work::Job job = work::plan_job(options);
  print_warnings(job.text_warnings);
  print_warnings(job.scene, job.season.get());
  if (options.dry_run)
    print_plan(job, /*with_pictures=*/false);
  else
    work::complete_job(job, without_pictures(work::stages_of(job)), progress);
  return ExitCode::done;
}

ExitCode run_render(const work::RenderOptions& options, Progress& progress) {
  const work::Job job = work::plan_job(options);
  print_warnings(job.text_warnings);
  print_warnings(job.scene, job.season.get());
  if (options.dry_run) {
    print_plan(job, /*with_pictures=*/true);
    return ExitCode::done;
  }
  const std::vector<work::StageTasks> stages = work::stages_of(job);
  work::complete_job(job, stages, progress);
  say_who_has_no_renderer(job, progress);
  std::string pictures;
  for (const int frame : job.frames)
    for (const work::StageTasks& stage : stages)
      if (work::makes_pictures(stage.stage))
        pictures += work::picture_path(job, {stage.stage, frame}).string() + "\n";
  console::print_data(pictures + pass_files(job));
  return ExitCode::done;
}

ExitCode run_passes(const work::RenderOptions& options, Progress& progress) {
  work::RenderOptions with_passes = options;
  if (with_passes.passes.empty()) with_passes.passes = "all";
  work::Job job = work::plan_job(with_passes);
  job.exporters.clear();
  print_warnings(job.text_warnings);
  if (options.dry_run) {
    print_plan(job, /*with_pictures=*/false);
    return ExitCode::done;
  }
  work::complete_job(job, work::stages_of(job), progress);
  console::print_data(pass_files(job));
  return ExitCode::done;
}

}  // namespace wold::cli
