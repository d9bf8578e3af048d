#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "landscape/landscape.h"

namespace wold::landscape {

/// Where a cell of the terrain is and how its patch stands there.
struct CellPose {
  glm::ivec2 cell{0};          ///< column (east) and row (north), from 0
  int turn = 0;                ///< quarter-turns counter-clockwise, seen from above
  glm::dvec2 lean{0.0};        ///< of what stands on it, along the ground (see meadow::WindLean)
  glm::dvec2 shift_m{0.0};     ///< of the patch's middle from that of the square at `cell`
  double size = 1.0;           ///< over the patch's own, in all directions
  double north_stretch = 1.0;  ///< its extent to the north over that to the east
  double shear = 0.0;          ///< of the turned patch, to the north for each metre to the east
};

/// Where the middle of the patch is on the ground; `patch_m`: its side.
glm::dvec2 middle_m(const CellPose& pose, double patch_m);

/// Where x of a cell points to after so many quarter-turns.
glm::dvec2 east_of(int turn);

/// A quarter-turn counter-clockwise, seen from above: from a cell's x to its y.
glm::dvec2 left_of(const glm::dvec2& direction);

/// How large what stands on a cell is, over its patch, by the cell's Cell::world_from_cell.
double size_of(const glm::dmat4& world_from_cell);

/// A part of a cell where it stands.
struct PlacedPart {
  Part part;
  glm::dmat4 world_from_cell{1.0};  ///< see Cell in landscape.h
};

/// A part on the plane that fits the ground under it, and how far that leaves the ground at most.
struct GroundFit {
  glm::dmat4 world_from_cell{1.0};
  double deviation_m = 0.0;
};

/// The plane rises as the ground does by least squares, and lies as far below the ground at one
/// place as above it at another. The deviation is exact: the ground is bilinear between its
/// samples, so it leaves a plane farthest at them or on the part's border. Of a sheared part it is
/// that of the rectangle around it.
GroundFit fit_to_ground(const Heightfield& terrain, double patch_m, const CellPose& pose,
                        const Part& part);

/// The parts of a cell, together its whole patch, none of which leaves the ground by more than
/// `tolerance_m`: the cell itself, or its quarters, each of them whole or in quarters, down to an
/// eighth of the side, where what is left is left. Borders lie between the voxels of a volume of
/// `voxels` a side (30, 62, 126 or 254), one before the even fraction of the side and two more:
/// where a border of one voxel goes before the volume, quarters consist of whole blocks of 8^3
/// voxels, OpenVDB's leaves, of which Blender builds its hulls.
std::vector<PlacedPart> parts_on_ground(const Heightfield& terrain, double patch_m,
                                        const CellPose& pose, int voxels, double tolerance_m);

/// The quarters of a whole patch, as parts_on_ground() makes them: by rows from the low corner.
std::array<Part, 4> quarters_of_patch(int voxels);

}  // namespace wold::landscape
