#include "work/plan.h"

#include "cli/commands.h"
#include "console/output.h"

namespace wold::cli {

ExitCode run_plan(const work::RenderOptions& options, PlanForm form) {
  const work::Job job = work::plan_job(options);
  const std::vector<work::StagePlan> plan = work::make_plan(job);
  switch (form) {
    case PlanForm::json:
      console::print_data(work::plan_json(job, plan));
      break;
    case PlanForm::openjd:
      console::print_data(work::plan_openjd(options, job, plan));
      break;
    default:
      console::print_data(work::plan_text(job, plan, form == PlanForm::why));
  }
  return ExitCode::done;
}

}  // namespace wold::cli
