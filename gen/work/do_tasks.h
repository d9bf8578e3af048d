#pragma once

#include <vector>

#include "work/work.h"

namespace wold::work {

/// Before minutes are spent on what could not be rendered: makes sure of the renderers of those
/// stages that have pictures to make. Writes nothing into the job's folder. Throws what
/// Renderers::require() throws, and FileError.
void require_renderers(const Job& job, const std::vector<StageTasks>& stages, Renderers& renderers);

/// Does those of the stages' tasks that need it, stage by stage, pictures of all renderers together
/// and several at once where there are threads and memory enough. Where pictures alone stay, scene
/// files and pictures are made batch by batch, and scene files that were shown go meanwhile. With
/// --memory the process keeps to it from here on, and so do renderers. Throws what Work::run()
/// throws, after the tasks under way have ended; what they have made stays.
void do_tasks(const Job& job, Work& work, const std::vector<StageTasks>& stages,
              Progress& progress);

}  // namespace wold::work
