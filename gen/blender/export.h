#pragma once

#include <filesystem>
#include <vector>

#include "landscape/landscape.h"

/// Writes landscapes for Blender 3.4 and later: one volume per baked texel (volume_file.h), the
/// frame as raw arrays, pictures and a small JSON file. The folder holds data only. The package
/// templates/blender/wold_blender makes a scene of it, in Blender's window or without.
///
///     folder/data/volumes/NAME.vdb         shared by all frames
///     folder/data/blades/NAME.*            meshes, shared by all frames (blade_files.h)
///     folder/data/flakes/NAME.png          pictures of flakes, shared by all frames
///     folder/data/frame_0001/frame.json    what the frame is made of; written last
///     folder/data/frame_0001/*.f32, *.i32  raw little-endian arrays (frame_data.h)
///     folder/data/frame_0001/*.exr         light, ground, sky, backdrop (frame_data.h)
///     folder/data/frame_0001/*.vdb         clouds and blown snow that are volumes
///     folder/data/frame_0001/expected.json what the picture should show (expected_picture.h)
namespace wold::blender {

/// Writes everything this frame needs below folder/data. Only volumes that cells use are written,
/// and those that are there already with the same content are left alone. Same landscape, same
/// bytes, so that frames may be written by several processes at a time. Returns the files that the
/// frame is made of. Throws FileError; every file that exists afterwards is whole.
std::vector<std::filesystem::path> export_frame(const landscape::Landscape& landscape,
                                                const std::filesystem::path& folder);

}  // namespace wold::blender
