#pragma once

#include <filesystem>

#include "landscape/landscape.h"

namespace wold::test {

/// What the synthetic meadow looks like.
struct SyntheticMeadow {
  int cells_per_side = 6;  ///< of 0.5 m
  int voxels = 30;         ///< per side of a cell: 30, 62, 126 or 254
  int height_voxels = 18;
  int volumes = 2;
  double slope = 0.15;  ///< of the hill, rise over run
  int width_px = 240;
  int height_px = 135;
};

/// A glowing pillar in the middle of a cell of 0.5 m, square, upright, open at the top.
landscape::BladeMesh pillar(const char* name, double width_m, double height_m,
                            const glm::vec3& radiance);

/// A small landscape that needs no simulator: straight keyed blades as volumes (written to
/// `folder`), a pillar on the last cell, a sloping ground, smooth light and sky. For the exporters'
/// tests and trials.
landscape::Landscape synthetic_landscape(const SyntheticMeadow& meadow,
                                         const std::filesystem::path& folder);

}  // namespace wold::test
