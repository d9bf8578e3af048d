#pragma once

#include "cli/film_demand.h"
#include "cli/tasks.h"
#include "scene/scene.h"

/// How many bytes a film's files take, before any of them is there. Fitted to what examples/ write:
/// for them right within 30 %, see README.md.
namespace wold::cli {

/// A baked texel of a level, on average over its states.
struct VolumeSize {
  double voxels = 0.0;  ///< of the box that is written: as high as the grass
  double filled = 0.0;  ///< of them, those with grass
};
VolumeSize volume_size(const scene::Grass& grass, int level);

/// Of the pictures of the ground that a frame has: the whole, and on large terrains finer ones
/// about the camera.
double ground_samples(const scene::Scene& scene);

/// All of DIR/texels.
double texel_bytes(const scene::Scene& scene, const FilmDemand& demand);

/// All of DIR/clouds.
double cloud_picture_bytes(const scene::Scene& scene);

/// The folder of a renderer, "blender" or "povray", with `frames` frames.
double scene_bytes(const scene::Scene& scene, Stage renderer, const FilmDemand& demand,
                   std::size_t frames);

/// One picture.
double picture_bytes(const scene::Scene& scene);

}  // namespace wold::cli
