#include "grass/texel/mingle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "grass/texel/rasterise.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

/// A withering patch of a seed of its own.
Texel patch(std::uint64_t seed, double weathering) {
  const scene::Scene scene = test::small_scene();
  const AgeingModel model(scene.ageing, scene.grass.specular);
  const auto blades =
      scatter_blades(scene.grass, scene.ageing, {scene.grass.patch_m, scene.grass.blades, seed, 0});
  PointDynamics dynamics(model, blades, sample_points(blades, test::small_shape(), 6.0, seed), 0.0);
  dynamics.advance_to(weathering);
  return rasterise_points(dynamics.points(), test::small_shape());
}

/// A texel of one voxel that is easily seen.
Texel one_voxel(float density, const glm::vec3& tangent, const glm::vec3& normal,
                const glm::vec3& albedo, float specular) {
  return {{1, 1, 1.0}, {0}, {density}, {tangent}, {normal}, {albedo}, {0.5F * albedo}, {specular}};
}

constexpr glm::vec3 up(0.0F, 0.0F, 1.0F);
constexpr glm::vec3 east(1.0F, 0.0F, 0.0F);
constexpr glm::vec3 north(0.0F, 1.0F, 0.0F);

TEST(Mingle, ASampleWithItselfIsTheSampleTwiceAsDense) {
  const Texel once = patch(7, 0.5);
  const Texel twice = mingle(std::vector<Texel>{once, once});
  ASSERT_EQ(twice.shape, once.shape);
  ASSERT_EQ(twice.voxel, once.voxel);
  ASSERT_GT(once.size(), 10000U);
  for (std::size_t i = 0; i < once.size(); ++i) {
    ASSERT_NEAR(twice.density[i] / once.density[i], 2.0F, 1e-5F);
    ASSERT_LT(glm::distance(twice.tangent[i], once.tangent[i]), 1e-5F);
    ASSERT_LT(glm::distance(twice.normal[i], once.normal[i]), 1e-5F);
    ASSERT_LT(glm::distance(twice.albedo[i], once.albedo[i]), 1e-6F);
    ASSERT_NEAR(twice.specular[i], once.specular[i], 1e-6F);
  }
}

TEST(Mingle, AreasAddUp) {
  const std::vector<Texel> samples = {patch(1, 0.0), patch(2, 0.4), patch(3, 1.0)};
  double area_m2 = 0.0;
  for (const Texel& sample : samples) area_m2 += sample.area_m2();
  const Texel sum = mingle(samples);
  EXPECT_NEAR(sum.area_m2() / area_m2, 1.0, 1e-6);
  for (const Texel& sample : samples) EXPECT_GT(sum.size(), sample.size());
  EXPECT_TRUE(std::is_sorted(sum.voxel.begin(), sum.voxel.end()));
}

TEST(Mingle, OppositeTangentsAreOneFibre) {
  const glm::vec3 t = glm::normalize(glm::vec3(0.3F, -0.4F, 0.5F));
  const Texel sum = mingle(
      std::vector<Texel>{one_voxel(1.0F, t, {}, {}, 0.0F), one_voxel(3.0F, -t, {}, {}, 0.0F)});
  EXPECT_GT(glm::dot(sum.tangent[0], t), 1.0F - 1e-6F);
}

TEST(Mingle, AttributesAreMeansByDensity) {
  const Texel sum =
      mingle(std::vector<Texel>{one_voxel(3.0F, up, east, {1.0F, 0.0F, 0.4F}, 0.4F),
                                one_voxel(1.0F, up, north, {0.0F, 1.0F, 0.0F}, 0.0F)});
  EXPECT_FLOAT_EQ(sum.density[0], 4.0F);
  EXPECT_LT(glm::distance(sum.albedo[0], glm::vec3(0.75F, 0.25F, 0.3F)), 1e-6F);
  EXPECT_NEAR(sum.specular[0], 0.3F, 1e-6F);
  EXPECT_LT(glm::distance(sum.normal[0], glm::normalize(glm::vec3(3.0F, 1.0F, 0.0F))), 1e-6F);
  // Normals from both sides of a vein cancel out to the vein's, zero.
  const Texel vein = mingle(std::vector<Texel>{one_voxel(1.0F, up, east, {}, 0.0F),
                                               one_voxel(1.0F, up, -east, {}, 0.0F)});
  EXPECT_EQ(vein.normal[0], glm::vec3(0.0F));
}

TEST(Mingle, SamplesHaveOneShape) {
  Texel coarse = one_voxel(1.0F, up, east, {}, 0.0F);
  const Texel fine = coarse;
  coarse.shape.voxel_m = 2.0;
  EXPECT_THROW(mingle(std::vector<Texel>{fine, coarse}), std::invalid_argument);
  EXPECT_THROW(mingle({}), std::invalid_argument);
}

}  // namespace
}  // namespace wold::grass
