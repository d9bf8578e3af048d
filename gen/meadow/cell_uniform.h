#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/random.h"

namespace wold::meadow {

/// A number in [0, 1) of a cell, keyed by a purpose.
inline double cell_uniform(std::uint64_t seed, const glm::ivec2& cell, const char* purpose) {
  const auto index =
      (static_cast<std::uint64_t>(cell.y) << 32) | static_cast<std::uint32_t>(cell.x);
  return random_uniform({seed, key_of("cell"), index, key_of(purpose)});
}

}  // namespace wold::meadow
