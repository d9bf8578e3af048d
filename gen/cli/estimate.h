#pragma once

#include "cli/tasks.h"
#include "cli/work.h"

namespace wold::cli {

/// What one task of a stage takes, roughly.
struct Estimate {
  double seconds = 0.0;
  double memory_bytes = 0.0;
  double disk_bytes = 0.0;
  bool measured = false;  ///< seconds and disk are the mean of tasks of this folder
};

/// From the scene's sizes; seconds and disk from records of the same stage where there are any.
Estimate estimate(const Job& job, const StageTasks& stage, const TaskRecords& records);

}  // namespace wold::cli
