#pragma once

#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "cli/job.h"
#include "core/progress.h"
#include "grass/time_varying_texel.h"
#include "landscape/cells.h"
#include "landscape/landscape.h"
#include "landscape/site.h"

namespace wold::cli {

/// From a checked scene to the scene folders of the renderers: terrain, choice of cells, the texels
/// they need, and one export per frame and renderer. What is there already and still right is kept.
class Film {
 public:
  explicit Film(const Job& job);

  /// Writes DIR/scene.toml, DIR/texels/, DIR/clouds/ where there are clouds, DIR/snow/ where snow
  /// lies on a large terrain, and the folders of the
  /// renderers the scene asks for. Throws FileError and InterruptedError; every file that exists
  /// then is whole.
  void generate(Progress& progress);

 private:
  void choose_cells(Progress& progress);
  void make_texels(Progress& progress);
  landscape::Volume volume(const landscape::CellChoice& cell) const;
  landscape::BladeMesh blades(const landscape::CellChoice& cell);
  std::vector<landscape::Volume> far_volumes(const grass::PatchState& state) const;
  void demand_far_field(int frame);
  void export_frames(Progress& progress);

  const Job& job_;
  landscape::Site site_;
  grass::TimeVaryingTexel texels_;
  std::vector<std::vector<landscape::CellChoice>> cells_;  ///< per frame of the job
  grass::TexelDemand demand_;
  std::map<std::pair<int, grass::PatchState>, landscape::BladeMesh> blades_;  ///< by variant
};

/// The renderers a scene asks for, by their folder names: "blender", "povray".
std::vector<std::string> wanted_renderers(const scene::Scene& scene);

}  // namespace wold::cli
