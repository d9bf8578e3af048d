#include "landscape/coarse_colours.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>

namespace wold::landscape {
namespace {

struct Fine {
  glm::ivec3 voxels;
  std::vector<float> brightness;
  std::vector<glm::vec3> colours;

  explicit Fine(glm::ivec3 size)
      : voxels(size),
        brightness(static_cast<std::size_t>(size.x * size.y * size.z), 0.0F),
        colours(brightness.size(), glm::vec3(0.0F)) {}
  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>((z * voxels.y + y) * voxels.x + x);
  }
  void set(glm::ivec3 at, float bright, const glm::vec3& light) {
    brightness[index(at.x, at.y, at.z)] = bright;
    colours[index(at.x, at.y, at.z)] = light;
  }
  ColourGrid coarse() const { return coarse_colours(brightness, colours, voxels); }
};

const glm::vec3& at(const ColourGrid& grid, int x, int y, int z) {
  return grid.values.at(static_cast<std::size_t>((z * grid.voxels.y + y) * grid.voxels.x + x));
}

TEST(CoarseColours, IsTheMeanOverWhatGlows) {
  Fine fine({4, 4, 4});
  fine.set({2, 2, 2}, 30.0F, {1.0F, 2.0F, 4.0F});
  fine.set({3, 3, 3}, 10.0F, {5.0F, 6.0F, 0.0F});
  const ColourGrid coarse = fine.coarse();
  EXPECT_EQ(coarse.voxels, glm::ivec3(2, 2, 3));
  EXPECT_FLOAT_EQ(at(coarse, 1, 1, 1).r, 2.0F);
  EXPECT_FLOAT_EQ(at(coarse, 1, 1, 1).g, 3.0F);
  EXPECT_FLOAT_EQ(at(coarse, 1, 1, 1).b, 3.0F);
}

// What each coarse voxel emits, brightness times colour, stays.
TEST(CoarseColours, KeepsWhatAVoxelEmits) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> number(0.0F, 1.0F);
  Fine fine({6, 6, 5});
  for (std::size_t i = 0; i < fine.brightness.size(); ++i)
    if (number(random) < 0.4F) {
      fine.brightness[i] = 900.0F * number(random);
      fine.colours[i] = {number(random), number(random), number(random)};
    }
  const ColourGrid coarse = fine.coarse();
  std::vector<glm::vec3> emitted(coarse.values.size(), glm::vec3(0.0F));
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x) {
        const std::size_t i = fine.index(x, y, z);
        const glm::vec3& shown = at(coarse, x / 2, y / 2, z / 2);
        emitted[static_cast<std::size_t>(((z / 2) * 3 + y / 2) * 3 + x / 2)] +=
            fine.brightness[i] * (shown - fine.colours[i]);
      }
  for (const glm::vec3& change : emitted)
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(change[channel], 0.0F, 0.01F);
}

// Renderers interpolate: air has no colour of its own to tint an edge with.
TEST(CoarseColours, AirHasTheColourOfTheMatterBesideIt) {
  const glm::vec3 green(0.1F, 0.3F, 0.05F);
  Fine fine({14, 14, 6});
  for (int z = 0; z < 6; ++z) fine.set({7, 3, z}, 200.0F, green);
  const ColourGrid coarse = fine.coarse();
  for (const glm::vec3& shown : coarse.values)
    for (int channel = 0; channel < 3; ++channel) EXPECT_FLOAT_EQ(shown[channel], green[channel]);
}

TEST(CoarseColours, OfNothingIsDark) {
  for (const glm::vec3& shown : Fine({6, 6, 2}).coarse().values) EXPECT_EQ(shown, glm::vec3(0.0F));
}

}  // namespace
}  // namespace wold::landscape
