#include "povray/coarse_radiance.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>

namespace wold::povray {
namespace {

struct Fine {
  glm::ivec3 voxels;
  std::vector<float> extinction;
  std::vector<glm::vec3> radiance;

  explicit Fine(glm::ivec3 size)
      : voxels(size),
        extinction(static_cast<std::size_t>(size.x * size.y * size.z), 0.0F),
        radiance(extinction.size(), glm::vec3(0.0F)) {}
  std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>((z * voxels.y + y) * voxels.x + x);
  }
  void set(glm::ivec3 at, float extinction_per_m, const glm::vec3& light) {
    extinction[index(at.x, at.y, at.z)] = extinction_per_m;
    radiance[index(at.x, at.y, at.z)] = light;
  }
  RadianceGrid coarse() const { return coarse_radiance(extinction, radiance, voxels); }
};

const glm::vec3& at(const RadianceGrid& grid, int x, int y, int z) {
  return grid.radiance.at(static_cast<std::size_t>((z * grid.voxels.y + y) * grid.voxels.x + x));
}

TEST(CoarseRadiance, IsTheMeanOverMatter) {
  Fine fine({4, 4, 4});
  fine.set({2, 2, 2}, 30.0F, {1.0F, 2.0F, 4.0F});
  fine.set({3, 3, 3}, 10.0F, {5.0F, 6.0F, 0.0F});
  const RadianceGrid coarse = fine.coarse();
  EXPECT_EQ(coarse.voxels, glm::ivec3(2, 2, 3));
  EXPECT_FLOAT_EQ(at(coarse, 1, 1, 1).r, 2.0F);
  EXPECT_FLOAT_EQ(at(coarse, 1, 1, 1).g, 3.0F);
  EXPECT_FLOAT_EQ(at(coarse, 1, 1, 1).b, 3.0F);
}

// What glows in each coarse voxel, extinction times radiance, stays.
TEST(CoarseRadiance, KeepsWhatAVoxelEmits) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> number(0.0F, 1.0F);
  Fine fine({6, 6, 5});
  for (std::size_t i = 0; i < fine.extinction.size(); ++i)
    if (number(random) < 0.4F) {
      fine.extinction[i] = 900.0F * number(random);
      fine.radiance[i] = {number(random), number(random), number(random)};
    }
  const RadianceGrid coarse = fine.coarse();
  std::vector<glm::vec3> emitted(coarse.radiance.size(), glm::vec3(0.0F));
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x) {
        const std::size_t i = fine.index(x, y, z);
        const glm::vec3& shown = at(coarse, x / 2, y / 2, z / 2);
        emitted[static_cast<std::size_t>(((z / 2) * 3 + y / 2) * 3 + x / 2)] +=
            fine.extinction[i] * (shown - fine.radiance[i]);
      }
  for (const glm::vec3& change : emitted)
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(change[channel], 0.0F, 0.01F);
}

// Extinction is interpolated, and reaches into the air beside matter.
TEST(CoarseRadiance, AirHasTheColourOfTheMatterBesideIt) {
  const glm::vec3 green(0.1F, 0.3F, 0.05F);
  Fine fine({14, 14, 6});
  for (int z = 0; z < 6; ++z) fine.set({7, 3, z}, 200.0F, green);
  const RadianceGrid coarse = fine.coarse();
  for (const glm::vec3& shown : coarse.radiance)
    for (int channel = 0; channel < 3; ++channel) EXPECT_FLOAT_EQ(shown[channel], green[channel]);
}

TEST(CoarseRadiance, OfNothingIsDark) {
  for (const glm::vec3& shown : Fine({6, 6, 2}).coarse().radiance)
    EXPECT_EQ(shown, glm::vec3(0.0F));
}

}  // namespace
}  // namespace wold::povray
