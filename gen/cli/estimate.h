#pragma once

#include "cli/tasks.h"
#include "cli/work.h"

namespace wold::cli {

/// What one task of a stage takes, roughly.
struct Estimate {
  double seconds = 0.0;
  double memory_bytes = 0.0;  ///< of the process that does it, see memory_of_process_bytes()
  double disk_bytes = 0.0;
  bool measured = false;  ///< seconds and disk are the mean of tasks of this folder
};

/// From the scene's sizes; seconds, disk and renderers' memory from what tasks of the same stage
/// and scene took, memory else from their scene files if these are there.
Estimate estimate(const Job& job, const StageTasks& stage, const Work& work);

}  // namespace wold::cli
