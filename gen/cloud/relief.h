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

/// height_m, droplets, sun_direction and pixel_m as for sunlit(); thickness_m: of the layer.
Relief relief_of(const LayerMap& ranks, const std::vector<float>& height_m,
                 const Droplets& droplets, const glm::dvec3& sun_direction, double pixel_m,
                 double thickness_m);

}  // namespace wold::cloud
