#pragma once

#include "work/file_sizes.h"
#include "work/tasks.h"
#include "work/work.h"

namespace wold::work {

/// What one task of a stage takes, roughly.
struct Estimate {
  double seconds = 0.0;
  double memory_bytes = 0.0;  ///< of the process that does it, see memory_of_process_bytes()
  double disk_bytes = 0.0;
  bool measured = false;  ///< seconds and disk are the mean of tasks of this folder
};

/// Of a stage of stages_of(): from what the job's frames show; seconds, disk and renderers' memory
/// from what tasks of the same stage and scene took, where some have been done. Throws what
/// FilmDemand does.
Estimate estimate(const Job& job, const StageTasks& stage, Work& work);

/// All scene files of the job. Throws what FilmDemand does.
SceneBytes scene_bytes(const Job& job, Work& work);

/// Estimate::memory_bytes alone, which for all but pictures asks for no demand.
double memory_bytes(const Job& job, const StageTasks& stage, Work& work);

}  // namespace wold::work
