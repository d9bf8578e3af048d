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

/// From the scene's sizes; seconds and disk from what tasks of the same stage and scene took.
Estimate estimate(const Job& job, const StageTasks& stage, const Work& work);

}  // namespace wold::cli
