#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/noise.h"

/// The noises that textures are sums of, with features of size 1; they repeat after `period`.
namespace wold::cloud {

/// Gradient noise with a standard deviation of 1.
inline double perlin(const glm::dvec2& at, std::uint64_t key, const glm::ivec2& period) {
  return gradient_noise(at, key, period) / gradient_noise_deviation;
}

/// Round heads: half-spheres, nearly, on the points of cellular noise.
inline double billow_cell(const glm::dvec2& at, std::uint64_t key, const glm::ivec2& period) {
  const double distance = cell_noise(at, key, period);
  return 1.0 - distance * distance;
}

}  // namespace wold::cloud
