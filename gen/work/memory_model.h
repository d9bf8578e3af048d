#pragma once

#include "exporter/costs.h"
#include "film/film_demand.h"
#include "work/job.h"

/// How much memory tasks take, in bytes that a process has of its own (memory_of_process_bytes()).
/// Fitted to runs of examples/ on 2 processors, see docs/measurements.md.
namespace wold::work {

/// Voxels of the finest level's cube.
double voxels_of(const scene::Scene& scene);

/// Making the texels of one variant.
double texel_memory_bytes(const Job& job);

/// Threads that make scene files: the job's, or as many as its memory is enough for.
int scene_threads(const Job& job);

/// Making the pictures of clouds.
double cloud_memory_bytes(const Job& job);

/// Making the scene files of any frame with the scene_threads().
double max_scene_memory_bytes(const Job& job);

/// Making those of one frame that shows no more than the demand.
double scene_memory_bytes(const Job& job, const film::FilmDemand& demand);

/// Making the passes of one frame.
double passes_memory_bytes(const Job& job, const film::FilmDemand& demand);

/// One renderer with one picture.
double renderer_memory_bytes(const Job& job, const exporter::MemoryCosts& costs,
                             const film::FrameDemand& shown);

}  // namespace wold::work
