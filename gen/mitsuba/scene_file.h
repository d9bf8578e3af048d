#pragma once

#include <string>
#include <vector>

#include "landscape/landscape.h"

namespace wold::mitsuba {

/// The text of a frame's scene.xml. World space is moved so that the eye is at 0: Mitsuba lifts
/// rays off surfaces by 0.09 mm for each metre that they are away from there. Metres; x east, y
/// north, z up; radiances in the landscape's unit, so that a picture times `exposure_gain`, a
/// parameter of the scene like `spp`, its samples per pixel, is what other renderers show before
/// they encode it as sRGB. `terrain` and `boulders`: names of files of the ground in the folder
/// above; "" where there are no boulders.
///
/// Cells of texels are boxes that stay apart by what rays are lifted: a ray that leaves one would
/// miss the wall of its neighbour in the same place. They reach a tenth of their patch's side into
/// the ground, where their grids are nothing. Throws FileError where a number is not
/// finite.
std::string scene_text(const landscape::Landscape& landscape, const std::string& terrain,
                       const std::string& boulders);

/// Clouds that the scene has: without hazes, in which other things stand. Mitsuba has one medium at
/// a place, which ends where the grass in it ends.
std::vector<const landscape::CloudBox*> shown_clouds(const landscape::Landscape& landscape);

/// Name of a cloud's file in the frame's folder.
std::string cloud_file(const landscape::CloudBox& cloud);

}  // namespace wold::mitsuba
