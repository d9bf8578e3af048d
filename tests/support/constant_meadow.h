#pragma once

#include <filesystem>

#include "landscape/landscape.h"

namespace wold::test {

/// A meadow whose grass is fog: every voxel has the same extinction and source radiance, the light
/// on it is 1, ground and sky have one radiance each. What a camera sees is known in closed form.
struct ConstantMeadow {
  int cells_per_side = 6;
  int voxels = 14;  ///< per side of a cell of 0.5 m
  int height_voxels = 8;
  int bare_voxels = 0;       ///< per side, in the east of each cell: nothing grows there
  float extinction = 2.45F;  ///< 1/m
  float radiance = 0.10F;
  float ground = 0.02F;
  float sky = 0.05F;
  double slope = 0.0;
  int width_px = 96;
  int height_px = 54;
};

/// The volume is written to `folder`. The exposure gain is 4, one ray per pixel.
landscape::Landscape constant_meadow(const ConstantMeadow& meadow,
                                     const std::filesystem::path& folder);

}  // namespace wold::test
