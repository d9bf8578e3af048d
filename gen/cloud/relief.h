#pragma once

#include <vector>

#include "cloud/sunlit.h"
#include "cloud/tiling.h"

namespace wold::cloud {

/// The coarse shape of a layer of heaps and its light, for who looks at its sides.
struct Relief {
  LayerMap ranks;                ///< smoothed over a sixth of the thickness; wider pixels
  std::vector<LayerMap> sunlit;  ///< sunlit() of these at evenly spaced heights, from the base on
};

/// The ranks of a relief. pixel_m: of the ranks given, thickness_m: of the layer.
LayerMap relief_ranks(const LayerMap& ranks, double pixel_m, double thickness_m);

/// Its light: height_m, droplets and sun_direction as for sunlit(), coarse_m the side of its
/// pixels.
std::vector<LayerMap> relief_light(const LayerMap& relief_ranks, const std::vector<float>& height_m,
                                   const Droplets& droplets, const glm::dvec3& sun_direction,
                                   double coarse_m);

}  // namespace wold::cloud
