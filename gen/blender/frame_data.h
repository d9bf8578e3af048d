#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "blender/colour_picture.h"
#include "landscape/landscape.h"

namespace wold::blender {

/// What cells of the frame show, as frame.json names it.
struct VolumeEntry {
  std::filesystem::path file;  ///< the .vdb
  ColourPicture colours;       ///< of its colour_file()
  double voxel_m = 0.0;        ///< side of its voxels
  double step_voxels = 1.0;    ///< length of a ray's step
  std::optional<int> quarter;  ///< this and light_map: see ShownVolume
  int light_map = 0;
};

/// Writes a frame's arrays, pictures and frame.json into `folder`. `volumes` are the ones in use
/// and `picks` is the index into them of each cell, or part of one; the landscape's meshes lie in
/// "blades" of `shared_folder`; its pictures of flakes are written to "flakes" there, NAME.png, of
/// which the name says what is in them: what is there already stays.
///
///   heights_m.f32          samples x samples, x fastest: the terrain
///   positions_m.f32        3 per cell
///   first_turns_rad.f32    3 per cell, and so on: see Placement
///   scales.f32
///   second_turns_rad.f32
///   picks.i32              1 per cell
///   part_middles_m.f32     3 per cell: middle of what is shown of it, in cell space
///   part_halves_m.f32      3 per cell: from there to its sides
///   blade_*.*32            the same five for the cells that are drawn as blades
///   flake_corners_m.f32    12 per flake: its corners from the lower left on against the clock,
///                          from the camera's eye; this and the next two only with flakes
///   flake_pictures.i32     1 per flake: index of its picture
///   flake_opacities.f32    1 per flake
///   light.exr, ground.exr  samples x samples on the corners of the terrain, north at the top
///   standing_light.exr     light.exr times how much stands, which is the fourth channel
///   light_1.exr, standing_light_1.exr   finer light on a square about the eye, whose first and
///                          last samples lie on the square's corners; the first only with blades
///   ground_detail_1.exr    finer pictures of parts of the ground, likewise on their corners; the
///                          fourth channel says how much of them is seen
///   sky.exr                as landscape::Landscape::sky
///
/// Arrays are little-endian without a header. Returns the files of `folder` that it has written.
/// Throws FileError.
std::vector<std::filesystem::path> write_frame_data(const landscape::Landscape& landscape,
                                                    const std::filesystem::path& folder,
                                                    const std::vector<VolumeEntry>& volumes,
                                                    const std::vector<int>& picks,
                                                    const std::filesystem::path& shared_folder);

}  // namespace wold::blender
