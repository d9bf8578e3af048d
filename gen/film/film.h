#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "film/assemble.h"
#include "film/request.h"
#include "film/scratch_folder.h"
#include "grass/texel/time_varying_texel.h"
#include "landscape/landscape.h"
#include "meadow/cells.h"
#include "meadow/far_field.h"
#include "meadow/frame_grass.h"
#include "passes/pass.h"
#include "place/site.h"

namespace wold::film {

/// From a checked scene to the scene folders of the renderers, part by part. What is there already
/// and still right is kept. The bytes of a file depend on the scene alone: not on the request's
/// frames, which say only which files there are, nor on what else was made, when, or by which
/// process.
///
/// All functions throw FileError and InterruptedError; every file that exists then is whole.
class FilmPipeline {
 public:
  /// Makes the light of the ground, growing_ground() of the request's scene. `request` has to
  /// outlive it.
  FilmPipeline(const Request& request, place::GrowingGround land);

  /// Which texels the request's frames ask for: looks at all of them. Before make_texels().
  void find_demand(Progress& progress);

  /// The texels of a variant, from 0 to below scene::patch_count(): DIR/texels/v<variant>_*; those
  /// without light where reads_unlit_texels(). Returns the files. Variants may be made at
  /// the same time.
  std::vector<std::filesystem::path> make_texels(int variant, Progress& progress) const;

  /// A picture of each layer of clouds: DIR/clouds/. Returns the files.
  std::vector<std::filesystem::path> make_cloud_pictures() const;

  /// A frame, from 1, in the folders of the request's exporters; its texels have to be there.
  /// Returns the files that it is made of, shared ones too.
  std::vector<std::filesystem::path> make_frame(int frame, Progress& progress);

  /// The passes of a frame, from 1: DIR/passes/0001.exr; its texels have to be there. Returns the
  /// file. Throws InputError where grass is drawn as points.
  std::vector<std::filesystem::path> make_passes(int frame, std::span<const passes::Pass> passes,
                                                 Progress& progress);

 private:
  PatchLookup patch_lookup();
  std::vector<meadow::CellChoice> cells_of(const meadow::FrameGrass& now) const;
  void demand_far_field(const meadow::FrameGrass& now);
  void demand(int variant, const grass::PatchState& state, int lod);
  landscape::Volume volume(const meadow::CellChoice& cell) const;
  landscape::BladeMesh blades(const meadow::CellChoice& cell);
  Tubes bent_blades(meadow::CellChoice cell);
  Tubes straight_blades(const meadow::CellChoice& cell) const;
  landscape::BladeMesh shaded_blades(const meadow::CellChoice& cell);
  meadow::PatchAppearance far_appearance(int mixture, const grass::PatchState& state);

  const Request& request_;
  ScratchFolder snow_;
  place::Site site_;
  grass::TimeVaryingTexel texels_;
  grass::TexelDemand demand_;
  /// By variant.
  std::map<std::tuple<int, grass::PatchState, grass::BladeBend>, landscape::BladeMesh> blades_;
  meadow::PatchAppearances far_appearances_;
};

/// Writes what the request's exporters write once for a film, such as a scene program, into their
/// folders. Throws FileError.
void write_film_files(const Request& request);

/// All that a request asks for: texels, pictures of clouds, scene files and what a film has once.
/// Returns the frames' files, each once. For callers that need no tasks, records or locks of work/:
/// nobody else may write into the folder meanwhile. Throws what FilmPipeline does, and InputError
/// where a frame is not one of the scene's and where machine_check.h has it.
std::vector<std::filesystem::path> make_film(const Request& request, Progress& progress);

}  // namespace wold::film
