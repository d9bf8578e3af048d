#include "grass/texel/rasterise.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/parallel.h"
#include "grass/texel/texel_builder.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

/// Points of one blade without a place on it: all that rasterising looks at.
Points loose_points(const std::vector<glm::vec3>& places_m) {
  Points points;
  const std::size_t count = places_m.size();
  points.blade_begin = {0, static_cast<std::uint32_t>(count)};
  points.arc_m.assign(count, 0.1F);
  points.position_m = places_m;
  points.tangent.assign(count, glm::normalize(glm::vec3(1.0F, -2.0F, 3.0F)));
  points.normal.assign(count, glm::normalize(glm::vec3(2.0F, 1.0F, 0.0F)));
  points.albedo.assign(count, {0.3F, 0.2F, 0.1F});
  points.transmittance.assign(count, {0.1F, 0.15F, 0.05F});
  points.specular.assign(count, 0.12F);
  points.area_m2.assign(count, 2e-6F);
  return points;
}

constexpr TexelShape shape{10, 8, 0.01};

TEST(Rasterise, KeepsMassNearTheGroundAndAcrossTheBorder) {
  for (const glm::vec3& place :
       {glm::vec3(0.055F, 0.055F, 0.041F), glm::vec3(0.05F, 0.05F, 0.0F),
        glm::vec3(0.0999F, 0.0001F, 0.03F), glm::vec3(-0.0301F, 0.2304F, 0.0001F),
        glm::vec3(0.05F, 0.05F, 0.0799F)})
    EXPECT_NEAR(rasterise_points(loose_points({place}), shape).area_m2() / 2e-6, 1.0, 1e-5)
        << "at height " << place.z;
}

TEST(Rasterise, WrapsAtTheBorder) {
  // The voxel (9, 0) is the left neighbour of (0, 0): both get the same from the face between.
  const Texel texel = rasterise_points(loose_points({{0.1F, 0.005F, 0.045F}}), shape);
  std::vector<float> dense(shape.voxels(), 0.0F);
  for (std::size_t i = 0; i < texel.size(); ++i) dense[texel.voxel[i]] = texel.density[i];
  EXPECT_GT(dense[shape.linear(9, 0, 4)], 0.0F);
  EXPECT_NEAR(dense[shape.linear(9, 0, 4)] / dense[shape.linear(0, 0, 4)], 1.0, 1e-4);
  EXPECT_NEAR(dense[shape.linear(0, 9, 4)] / dense[shape.linear(0, 1, 4)], 1.0, 1e-4);
}

// Section 2.3: w = exp(-d^2 / (2 sigma^2)), sigma 0.6 voxels; an edge is shared with a voxel
// sqrt(2) off.
TEST(Rasterise, WeighsByTheGaussian) {
  const Texel texel = rasterise_points(loose_points({{0.055F, 0.055F, 0.045F}}), shape);
  ASSERT_EQ(texel.size(), 19U);
  const float largest = *std::max_element(texel.density.begin(), texel.density.end());
  const float min = *std::min_element(texel.density.begin(), texel.density.end());
  EXPECT_NEAR(min / largest, std::exp(-1.0 / 0.36), 1e-4);
}

// A point a tenth of a voxel below the upper face is 0.6 voxels from the middle of the slice above
// and 1.4 from that of the slice below.
TEST(Rasterise, GivesMoreToTheNearerSlice) {
  const Texel texel = rasterise_points(loose_points({{0.055F, 0.055F, 0.049F}}), shape);
  std::vector<float> dense(shape.voxels(), 0.0F);
  for (std::size_t i = 0; i < texel.size(); ++i) dense[texel.voxel[i]] = texel.density[i];
  const float above = dense[shape.linear(5, 5, 5)], middle = dense[shape.linear(5, 5, 4)];
  EXPECT_NEAR(above / middle, std::exp(-(0.36 - 0.16) / 0.72), 1e-3);
  EXPECT_LT(dense[shape.linear(5, 5, 3)], 0.2F * above);
}

TEST(Rasterise, ConstantFieldStaysConstant) {
  std::vector<glm::vec3> places;
  for (int i = 0; i < 40; ++i)
    places.emplace_back(0.0021F * static_cast<float>(i), 0.0013F * static_cast<float>(i * i % 70),
                        0.0011F * static_cast<float>(i * 7 % 60));
  const Points points = loose_points(places);
  const Texel texel = rasterise_points(points, shape);
  ASSERT_GT(texel.size(), 100U);
  for (std::size_t i = 0; i < texel.size(); ++i) {
    EXPECT_LT(glm::distance(texel.albedo[i], points.albedo[0]), 1e-6F);
    EXPECT_LT(glm::distance(texel.transmittance[i], points.transmittance[0]), 1e-6F);
    EXPECT_NEAR(texel.specular[i], 0.12F, 1e-6F);
    EXPECT_GT(glm::dot(texel.tangent[i], points.tangent[0]), 1.0F - 1e-6F);
    EXPECT_GT(glm::dot(texel.normal[i], points.normal[0]), 1.0F - 1e-6F);
  }
  EXPECT_TRUE(std::is_sorted(texel.voxel.begin(), texel.voxel.end()));
}

TEST(Rasterise, IsTheSameForAnyNumberOfThreads) {
  std::vector<glm::vec3> places;
  for (int i = 0; i < 3000; ++i)
    places.emplace_back(0.0007F * static_cast<float>(i * 13 % 151),
                        0.0011F * static_cast<float>(i * i % 97),
                        0.0005F * static_cast<float>(i * 7 % 163));
  const Points points = loose_points(places);
  const Texel many = rasterise_points(points, shape);
  const ThreadLimit limit(1);
  const Texel one = rasterise_points(points, shape);
  EXPECT_EQ(many.voxel, one.voxel);
  EXPECT_EQ(many.density, one.density);
  EXPECT_EQ(many.tangent, one.tangent);
}

/// A bit of grass.
struct Bit {
  float area_m2;
  glm::vec3 tangent, normal, albedo;
  float specular;
};

/// Everything in the one voxel of a texel.
class OneVoxel {
 public:
  explicit OneVoxel(const std::vector<Bit>& all) : all_(all) {}
  template <class Visit>
  void each_in_slice(int, const Visit& visit) const {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const VoxelWeight whole{0, all_[i].area_m2};
      visit(i, std::span<const VoxelWeight, 1>(&whole, 1));
    }
  }
  Moments moments(std::size_t which) const {
    const Bit& bit = all_[which];
    return {bit.tangent, bit.normal, bit.albedo, 0.25F * bit.albedo, bit.specular};
  }

 private:
  const std::vector<Bit>& all_;
};

Texel mixed_in_one_voxel(const std::vector<Bit>& all) {
  double area_m2 = 0.0;
  for (const Bit& one : all) area_m2 += double{one.area_m2};
  return build_texel({1, 1, 1.0}, OneVoxel(all), area_m2);
}

TEST(BuildTexel, OppositeTangentsAreTheSameFibre) {
  const glm::vec3 t = glm::normalize(glm::vec3(0.3F, -0.4F, 0.5F));
  const Texel texel = mixed_in_one_voxel({{1.0F, t, {}, {}, 0.0F}, {2.0F, -t, {}, {}, 0.0F}});
  EXPECT_GT(glm::dot(texel.tangent[0], t), 1.0F - 1e-6F);
}

// Two fibres +-30 degrees off x with equal area: the mean fibre is x; with more area of one it
// turns to the angle a with tan 2a = sin 60 (p - q) / (cos 60 (p + q)).
TEST(BuildTexel, MainAxisOfTwoFibres) {
  const auto fibre = [](double angle) { return glm::vec3(std::cos(angle), 0.0F, std::sin(angle)); };
  const double angle = 30.0 * test::degree;
  const auto mean = [&](float p, float q) {
    const glm::vec3 t =
        mixed_in_one_voxel({{p, fibre(angle), {}, {}, 0.0F}, {q, fibre(-angle), {}, {}, 0.0F}})
            .tangent[0];
    return std::atan(double{t.z} / double{t.x});
  };
  EXPECT_NEAR(mean(1.0F, 1.0F), 0.0, 1e-3);
  const double expected = 0.5 * std::atan(std::tan(2.0 * angle) * (3.0 - 1.0) / (3.0 + 1.0));
  EXPECT_NEAR(mean(3.0F, 1.0F), expected, 1e-3);
}

TEST(BuildTexel, AlbedoIsTheMeanByArea) {
  const Texel texel = mixed_in_one_voxel({{3.0F, {0, 0, 1}, {}, {1.0F, 0.0F, 0.0F}, 0.4F},
                                          {1.0F, {0, 0, 1}, {}, {0.0F, 1.0F, 0.0F}, 0.0F}});
  EXPECT_LT(glm::distance(texel.albedo[0], glm::vec3(0.75F, 0.25F, 0.0F)), 1e-6F);
  EXPECT_NEAR(texel.specular[0], 0.3F, 1e-6F);
  EXPECT_FLOAT_EQ(texel.density[0], 4.0F);
}

}  // namespace
}  // namespace wold::grass
