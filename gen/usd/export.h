#pragma once

#include <filesystem>
#include <vector>

#include "landscape/landscape.h"

/// Writes landscapes as USD stages, in text (.usda), which hosts read with the pictures and OpenVDB
/// files beside them.
///
///     folder/frame.0001.usda             a stage of one frame, written last (frame_stage.h)
///     folder/scene.usda                  the film (film_stage.h)
///     folder/data/ground_HASH.usda       the ground, shared by frames with the same
///     (ground_file.h) folder/data/blades/NAME.*          blades, shared by all frames
///     (blade_files.h) folder/data/volumes/NAME.vdb       texels, shared by all frames
///     (volume_file.h) folder/data/flakes/NAME.png        opacity of flakes, shared by all frames
///     folder/data/frame_0001/*.exr       sky, ground and what is before the sky
///     folder/data/frame_0001/*.vdb clouds and blown snow as volumes
///
/// Left out: fog; what tints texels by place; parts of cells of texels, which lie whole on the mean
/// of how their parts lie. Blades are lighter
/// and darker by place in steps of a fifth of an octave.
namespace wold::usd {

/// Writes everything this frame needs. Same landscape, same bytes, so that frames may be written by
/// several processes at a time. Returns the files that the frame is made of. Throws FileError, and
/// InputError where the landscape has no Landscape::unlit. Every file that exists afterwards is
/// whole.
std::vector<std::filesystem::path> export_frame(const landscape::Landscape& landscape,
                                                const std::filesystem::path& folder);

}  // namespace wold::usd
