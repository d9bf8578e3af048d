#include "core/tubes.h"

#include <gtest/gtest.h>

namespace wold {
namespace {

// Two tubes of three rings with four corners: 2 * 2 * 4 faces that look outwards and never join one
// tube to the other.
TEST(Tubes, FacesLookOutwardsAndStayOnTheirTube) {
  Tubes tubes{3, 4, {}, {}};
  for (int tube = 0; tube < 2; ++tube)
    for (int ring = 0; ring < 3; ++ring) {
      for (const glm::vec2 corner : {glm::vec2(1, 0), {0, 1}, {-1, 0}, {0, -1}})
        tubes.vertices_m.emplace_back(corner + 5.0F * static_cast<float>(tube), ring);
      tubes.radiance.emplace_back(1.0F);
    }
  const std::vector<std::uint32_t> quads = quad_corners(tubes);
  ASSERT_EQ(quads.size(), 2U * 2U * 4U * 4U);
  for (std::size_t face = 0; face < quads.size(); face += 4) {
    const auto at = [&](std::size_t corner) { return tubes.vertices_m[quads[face + corner]]; };
    const glm::vec3 middle = (at(0) + at(1) + at(2) + at(3)) / 4.0F;
    const glm::vec3 axis(glm::vec2(quads[face] < 12 ? 0.0F : 5.0F), middle.z);
    const glm::vec3 normal = glm::cross(at(1) - at(0), at(3) - at(0));
    EXPECT_GT(glm::dot(normal, middle - axis), 0.0F);
    EXPECT_LT(glm::distance(middle, axis), 1.0F);
  }
}

}  // namespace
}  // namespace wold
