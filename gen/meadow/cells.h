#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "core/ground_map.h"
#include "grass/ageing/patch_state.h"
#include "grass/geometry/blade_bend.h"
#include "landscape/cell_parts.h"
#include "meadow/frame_grass.h"
#include "place/cell_window.h"
#include "place/mixture_field.h"
#include "place/withering.h"
#include "scene/scene.h"

namespace wold::meadow {

/// How shrubs stand beside their cell.
struct BesideCell {
  glm::dmat4 world_from_patch{1.0};  ///< on the plane that fits the ground under all of it
  double standing = 1.0;             ///< the fraction of them that is shown
};

/// Which texel stands on a cell of the terrain, and how. `key_frame` and `lod` are indices into
/// the scene's grass.key_frames and grass.levels; `variant` is a patch of scene::patch_count();
/// `snow` and `light` are those of PatchState;
/// `turn` counts quarter-turns counter-clockwise, seen from above.
struct CellChoice {
  std::vector<landscape::PlacedPart> parts;  ///< of the patch, as the ground needs
  glm::dmat4 reach{1.0};                     ///< see Cell in landscape.h
  glm::ivec2 cell{0};                        ///< column (east) and row (north), from 0
  int variant = 0;
  int key_frame = 0;
  int snow = 0;
  int light = 0;
  int turn = 0;
  int lod = 0;
  std::optional<BesideCell> beside_cell;  ///< of shrubs that stand there, not on the cell
  bool blades = false;      ///< drawn as a mesh of blades or points, not as the volume of `lod`
  grass::BladeBend bend{};  ///< of that mesh; what it leaves of the lean `parts` have

  grass::PatchState state() const { return {key_frame, snow, light}; }
};

/// How far what is drawn of a cell may leave the ground under it.
constexpr double ground_tolerance_m = 0.01;

/// Cell::reach of a cell that meets its neighbours `height_m` above the ground: where they lean
/// away from each other both reach half as far beyond their cells as the gap between them is wide
/// there.
glm::dmat4 reach_to_neighbours(const WindLean& wind_lean, double patch_m,
                               const landscape::CellPose& pose, double height_m);

/// How many of the four quarter-turns a level uses. A turn needs its own baked light and its own
/// place in a renderer's memory, 200 MB for a volume of 254^3: 1 from 200 voxels per side on, 2
/// from 50 on, else 4.
int turns_of_lod(int voxels_per_side);

/// How many of them cells of a scene use of a level: a coat has one nap.
int turns_of_lod(const scene::Scene& scene, int lod);

/// How far from the middle of a cell, on the ground, what stands on it and beside it may reach.
double cell_reach_m(const scene::Scene& scene);

/// A square on the ground, in metres, beyond which the grass of cells does not reach; of one cell
/// at least.
Square square_of_cells(const scene::Scene& scene, std::span<const CellChoice> cells);
/// The same of all cells from the south-western `low` to the north-eastern `high`.
Square square_of_cells(const scene::Scene& scene, const glm::ivec2& low, const glm::ivec2& high);

/// Every cell with grass that can be seen, row by row: in the CellWindow, inside the picture, not
/// behind a hill, not so far that far_fraction() paints it. `growth` is growth_map()'s; where it is
/// thin, blades stand on as many cells as it says, while volumes are thinned in space.
///
/// The mixture of species is that of the cell's middle. A cell with shrubs among it is listed
/// twice: first with what grows around them, if anything does, then with them, where shrub_place()
/// puts them, if it is not bare there. Variant and turn are choose_texels()'. Key frame, level of
/// snow and light are those below or above the cell's weathering and the frame's snow and light, in
/// the mean as much as these; variants pass from one to the next one after another, so that few
/// pairs of variant and state are seen at once. The level is the coarsest whose voxels cover at
/// most grass.pixels_per_voxel, of larger shrubs as of others, with a keyed tenth of jitter, so
/// that no ring shows where levels change. A cell has as many parts as ground_tolerance_m asks for;
/// shrubs, whose feet grass hides, as five times that. Only `lod` (and with it the turns allowed),
/// `parts` and whether a cell is listed depend on the camera. Cells are drawn as render.grass asks:
/// with "auto" as blades where even the finest level is too coarse.
std::vector<CellChoice> choose_cells(const scene::Scene& scene, const Heightfield& terrain,
                                     const FactorMap& growth, const place::MixtureField& mixtures,
                                     const place::Withering& withering, const FrameGrass& now);

}  // namespace wold::meadow
