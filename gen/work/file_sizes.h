#pragma once

#include <set>
#include <span>
#include <vector>

#include "exporter/costs.h"
#include "film/film_demand.h"
#include "passes/pass.h"
#include "scene/scene.h"

/// How many bytes a film's files take, before any of them is there. Fitted to what examples/ write:
/// for them right within 30 %, see docs/measurements.md.
namespace wold::work {

/// A baked texel.
struct VolumeSize {
  double voxels = 0.0;  ///< of the box that is written: as high as the grass
  double filled = 0.0;  ///< of them, those with grass
};

/// A patch with the blades of one species alone.
struct SpeciesPatch {
  scene::Grass grass;
  scene::Flower flower = {};
};

/// Of a patch at a level, withered to a degree in [0, 1], under a share in [0, 1] of the snow that
/// it can carry: withering makes it lower and thinner, snow lower alone, and flowers stay where
/// they are.
VolumeSize volume_size(const SpeciesPatch& patch, int lod, double weathering, double snow);

/// Sizes of a scene's volumes, whose weathering degrees are the scene's key frames. That of a
/// variant is as high as the highest species of its mixture and filled by all of them.
class VolumeSizes {
 public:
  explicit VolumeSizes(const scene::Scene& scene);
  VolumeSize of(int variant, const grass::PatchState& state, int lod) const;

 private:
  int variants_;
  /// By mixture, the patch as each of its species has it.
  std::vector<std::vector<SpeciesPatch>> species_;
  std::vector<double> key_frames_;
};

/// Volumes that differ in their quarter-turn alone, once: with turn 0.
std::set<film::ShownVolume> without_turns(const std::set<film::ShownVolume>& volumes);

/// Of a voxel in so many density files of render.df3_bits.
double density_bytes(const scene::Scene& scene, double grids);

/// Of the pictures of the ground that a frame has: the whole, and on large terrains finer ones
/// about the camera.
double ground_samples(const scene::Scene& scene);
/// Of this frame: snow may ask for finer ones.
double ground_samples(const scene::Scene& scene, const film::FrameDemand& shown);

/// Of the clouds that stand as volumes in a frame.
double cloud_voxels(const scene::Scene& scene);

/// All of DIR/texels; with the texels that have no light, or not.
double texel_bytes(const scene::Scene& scene, const film::FilmDemand& demand, bool with_unlit);

/// All of DIR/clouds.
double cloud_picture_bytes(const scene::Scene& scene);

/// Scene files: what frames share, once, and what a frame has of its own in the mean.
struct SceneBytes {
  double shared = 0.0, own = 0.0;

  double of(std::size_t frames) const { return shared + own * static_cast<double>(frames); }
};

/// The folder of an exporter.
SceneBytes scene_bytes(const scene::Scene& scene, const exporter::FileCosts& costs,
                       const film::FilmDemand& demand);

/// The passes of one frame.
double pass_bytes(const scene::Scene& scene, std::span<const passes::Pass> passes);

/// One picture.
double picture_bytes(const scene::Scene& scene);

}  // namespace wold::work
