#pragma once

#include <filesystem>
#include <vector>

#include "landscape/landscape.h"

/// Writes landscapes for Mitsuba 3.5 and later, which follows light from its sources through
/// leaves, grass and clouds to the camera: the reference that baked light is held against. The
/// folder holds data only; templates/mitsuba/render.py renders it.
///
///     folder/data/frame_0001/scene.xml       the scene; paths in it start from its own folder
///     folder/data/frame_0001/sky.exr         radiance of the sky without a sun
///     folder/data/frame_0001/ground.exr      albedo of the ground
///     folder/data/frame_0001/cloud_*.vol     extinction of clouds that are volumes (grid_file.h)
///     folder/data/terrain_HASH.ply           the ground, shared by frames with the same ground
///     folder/data/leaves/NAME.ply, NAME_*.exr  blades and what they do with light (leaf_files.h)
///     folder/data/texels/NAME_*.vol          extinction and albedo of texels, in 1/m and 1
///
/// Left out: flakes and fog, whose light is known only as it is baked; tints of the grass by place,
/// which multiply baked light; haze before what is far; grass painted on far ground.
namespace wold::mitsuba {

/// Writes everything this frame needs below folder/data. Same landscape, same bytes, so that frames
/// may be written by several processes at a time. Returns the files that the frame is made of.
/// Throws FileError, and InputError where the landscape is not known without its light: it has no
/// Landscape::unlit, or points are drawn for blades. Every file that exists afterwards is whole.
std::vector<std::filesystem::path> export_frame(const landscape::Landscape& landscape,
                                                const std::filesystem::path& folder);

}  // namespace wold::mitsuba
