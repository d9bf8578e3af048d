#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace wold::cloud {

/// Round heads in space: two octaves of inverted cellular noise in a cube that repeats, so that it
/// is made once and looked up at any scale. Worley 1996; heads as in procedural_texture.h.
class BillowBox {
 public:
  /// Heads of the first octave along a side.
  static constexpr int billow_cells = 6;

  explicit BillowBox(std::uint64_t key);

  /// In [0, 1], 1 at the heads' middles; the place is in cubes, any numbers below 2^31. Trilinear.
  float at(const glm::vec3& place) const;

 private:
  static constexpr int side = 48;
  std::vector<float> values_;  ///< x fastest
};

}  // namespace wold::cloud
