#pragma once

#include <vector>

#include "core/progress.h"
#include "work/work.h"

namespace wold::work {

/// Does what is missing of the stages' tasks, alone in the job's folder, removes what the job does
/// not keep, and lists its files in manifest.json. Before anything is written, it asks for
/// renderers, memory and disk. Throws InputError, RendererError and FileError.
void complete_job(const Job& job, const std::vector<StageTasks>& stages, Progress& progress);

}  // namespace wold::work
