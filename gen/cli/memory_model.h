#pragma once

#include <string_view>

#include "cli/job.h"
#include "cli/task_record.h"

/// How much memory tasks take, in bytes that a process has of its own (memory_of_process_bytes()).
/// Fitted to runs of examples/ at 480x270 on 2 processors, see README.md: for them right within a
/// quarter where scene files are known, within a factor of 2.1 where they are guessed.
namespace wold::cli {

/// Voxels of the finest level's cube.
double voxels_of(const scene::Scene& scene);

/// Making the texels of one variant.
double texel_memory_bytes(const Job& job);

/// Threads that make scene files: the job's, or as many as its memory is enough for.
int scene_threads(const Job& job);

/// Making the scene files of one frame with these.
double scene_memory_bytes(const Job& job);

/// Bytes of those files of a frame that a renderer's memory grows with.
struct SceneFiles {
  double volume_bytes = 0.0;  ///< .vdb or .df3
  double cell_bytes = 0.0;    ///< .f32 or .inc: ground and cells
  double part_bytes = 0.0;    ///< of these, cells.inc: a line for each part of a cell
};

SceneFiles files_of(const TaskRecord& scenes, std::string_view renderer);

/// Before there are any.
SceneFiles guessed_files(const scene::Scene& scene, Stage stage);

/// One renderer with one picture.
double renderer_memory_bytes(const Job& job, Stage stage, const SceneFiles& files);

}  // namespace wold::cli
