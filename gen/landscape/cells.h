#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/ground_map.h"
#include "grass/patch_state.h"
#include "landscape/cell_window.h"
#include "landscape/combing.h"
#include "landscape/withering.h"
#include "scene/scene.h"

namespace wold::landscape {

/// Which texel stands on a cell of the terrain, and how. `key_frame` and `level` are indices into
/// the scene's grass.key_frames and grass.levels; `snow` and `light` are those of PatchState;
/// `turn` counts quarter-turns counter-clockwise, seen from above.
struct CellChoice {
  glm::dmat4 world_from_cell{1.0};  ///< see Cell in landscape.h
  glm::dmat4 reach{1.0};            ///< likewise
  glm::ivec2 cell{0};               ///< column (east) and row (north), from 0
  int variant = 0;
  int key_frame = 0;
  int snow = 0;
  int light = 0;
  int turn = 0;
  int level = 0;
  bool blades = false;  ///< drawn as a mesh of blades or points, not as the volume of `level`

  grass::PatchState state() const { return {key_frame, snow, light}; }
};

/// The best affine fit of the ground under a cell, after `turn` quarter-turns about the patch's
/// centre: least squares through the four corners, which leaves |z00 - z10 - z01 + z11| / 4 at
/// each. What stands on it leans over by `lean` (see Combing) along the ground.
glm::dmat4 world_from_cell(const Heightfield& terrain, double patch_m, const glm::ivec2& cell,
                           int turn, const glm::dvec2& lean);

/// Cell::reach of a cell whose grass is `height_m` high: where neighbours lean away from each other
/// both reach half as far beyond their squares as the gap between them is wide at that height.
glm::dmat4 reach_to_neighbours(const Combing& combing, double patch_m, const glm::ivec2& cell,
                               int turn, double height_m);

/// How many of the four quarter-turns a level uses. A turn needs its own baked light, and a volume
/// of 254^3 takes about 200 MB in a renderer: 1 from 200 voxels per side on, 2 from 100 on, else 4.
int turns_of_level(int voxels_per_side);

/// How many of them cells of a scene use of a level: a coat has one nap.
int turns_of_level(const scene::Scene& scene, int level);

/// Every cell with grass that can be seen, row by row: in the CellWindow, inside the picture, not
/// behind a hill, not so far that far_share() paints it. `growth` is growth_map()'s; where it is
/// thin, blades stand on as many cells as it says, while volumes are thinned in space. Variant and
/// turn by keyed choice, so that neighbours differ; the key frame by keyed dithering between the
/// two nearest to the local weathering, the level of snow likewise to canopy_snow(), the light to
/// light_of_frame(); the coarsest level whose voxels cover at most grass.pixels_per_voxel, with a
/// keyed tenth of jitter, so that no ring shows where levels change. Only `level` (and with it the
/// turns allowed) and whether a cell is listed depend on the camera. Cells are drawn as
/// render.grass asks: with "auto" as blades where even the finest level is too coarse. Frame from
/// 1; throws InputError when the scene has no such frame.
std::vector<CellChoice> choose_cells(const scene::Scene& scene, const Heightfield& terrain,
                                     const FactorMap& growth, const Withering& withering,
                                     int frame);

}  // namespace wold::landscape
