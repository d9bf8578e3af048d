#pragma once

#include <filesystem>
#include <vector>

#include "landscape/landscape.h"

/// Writes landscapes as Blender 3.4 scenes: one volume per baked texel, or per part of one
/// (volume_file.h), the frame as raw arrays, pictures and a small JSON file, and scene.py, which
/// renders them with Cycles. The folder needs nothing else: copied to a machine that has Blender it
/// makes the same picture.
///
///     folder/scene.py, wold_addon.py
///     folder/data/volumes/NAME.vdb         shared by all frames
///     folder/data/blades/NAME.*            meshes, shared by all frames (blade_files.h)
///     folder/data/flakes/NAME.png          pictures of flakes, shared by all frames
///     folder/data/frame_0001/frame.json    what the frame is made of; written last
///     folder/data/frame_0001/*.f32, *.i32  raw little-endian arrays (frame_data.h)
///     folder/data/frame_0001/*.exr         light, ground, sky, backdrop (frame_data.h)
///     folder/data/frame_0001/cloud_*.vdb   clouds that are volumes
///     folder/data/frame_0001/expected.json what the picture should show (expected_picture.h)
namespace wold::blender {

/// Writes everything this frame needs below folder/data. Only volumes that cells use are written,
/// and those that are there already with the same content are left alone. Same landscape, same
/// bytes, so that frames may be written by several processes at a time. Returns the files that the
/// frame is made of. Throws FileError; every file that exists afterwards is whole.
std::vector<std::filesystem::path> export_frame(const landscape::Landscape& landscape,
                                                const std::filesystem::path& folder);

/// Writes folder/scene.py, the program that renders any exported frame:
/// `blender -b --python-exit-code 1 -P scene.py -- FRAME`, and folder/wold_addon.py, by which
/// Blender imports the folder into any scene. Throws FileError.
void export_scene(const std::filesystem::path& folder);

}  // namespace wold::blender
