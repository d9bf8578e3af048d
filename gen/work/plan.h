#pragma once

#include <string>
#include <vector>

#include "work/estimate.h"
#include "work/work.h"

namespace wold::work {

/// Tasks of a stage with one verdict.
struct TaskGroup {
  std::vector<int> indices;  ///< rising
  Verdict verdict;
};

/// What is to be done of a stage.
struct StagePlan {
  StageTasks tasks;
  Estimate each;                  ///< of one task
  std::vector<TaskGroup> groups;  ///< in the order of their first tasks
  std::size_t runs = 0;           ///< tasks that are needed
  std::size_t perhaps = 0;        ///< tasks that may turn out to be
  double disk_bytes = 0.0;        ///< of all these, as far as they are there at the same time
};

/// The verdict on every task of a job, without doing or writing anything.
std::vector<StagePlan> make_plan(const Job& job);

/// For people: a line per stage; with `why` one more for each reason.
std::string plan_text(const Job& job, const std::vector<StagePlan>& plan, bool why);

/// The stable form, see docs/tasks.md.
std::string plan_json(const Job& job, const std::vector<StagePlan>& plan);

/// A job template of Open Job Description (2023-09), whose tasks call `wold task` for the scene
/// file with the same options.
std::string plan_openjd(const RenderOptions& options, const Job& job,
                        const std::vector<StagePlan>& plan);

}  // namespace wold::work
