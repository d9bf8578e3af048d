#pragma once

#include <filesystem>

#include "core/image.h"
#include "landscape/coarse_colours.h"

namespace wold::blender {

/// How the colours of what a volume emits lie in a picture. Cycles keeps a picture as bytes, but a
/// grid as larger numbers, beside OpenVDB's and with the air about its voxels.
///
/// The picture is a column of slices of the grid of colours, the lowest uppermost: the lowest slice
/// of the grid, then all of them from the lowest on, then the highest again. Each has side + 2
/// pixels along x and y, of which the outer ones repeat the other side, as the patch does. Row and
/// column grow with y and x. A pixel in [0, 1] times `scale` is a colour of luminance 1.
struct ColourPicture {
  int side = 0;        ///< of the grid of colours, in voxels
  int slices = 0;      ///< in the picture
  float scale = 1.0F;  ///< largest number of any colour
};

/// Of a grid that is as long as it is wide.
ColourPicture colour_picture_of(const landscape::ColourGrid& colours);

/// The pixels, 3 channels.
Image pixels_of(const ColourPicture& picture, const landscape::ColourGrid& colours);

}  // namespace wold::blender
