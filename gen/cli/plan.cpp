#include "work/plan.h"

#include "cli/commands.h"
#include "cli/output.h"

namespace wold::cli {

ExitCode run_plan(const work::RenderOptions& options, PlanForm form) {
  const work::Job job = work::plan_job(options);
  const std::vector<work::StagePlan> plan = work::make_plan(job);
  switch (form) {
    case PlanForm::json:
      print_data(work::plan_json(job, plan));
      break;
    case PlanForm::openjd:
      print_data(work::plan_openjd(options, job, plan));
      break;
    default:
      print_data(work::plan_text(job, plan, form == PlanForm::why));
  }
  return ExitCode::done;
}

}  // namespace wold::cli
