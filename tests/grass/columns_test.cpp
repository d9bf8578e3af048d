#include "grass/texel/columns.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/random.h"
#include "rotated.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

using test::degree;

constexpr TexelShape shape{20, 12, 0.01};

const std::vector<glm::dvec3>& directions() {
  static const std::vector<glm::dvec3> all = {{0.0, 0.0, 1.0},
                                              direction_at(70.0 * degree, 0.3),
                                              direction_at(45.0 * degree, 2.0),
                                              direction_at(20.0 * degree, 4.0),
                                              direction_at(6.0 * degree, 5.5)};
  return all;
}

std::vector<std::uint32_t> every_voxel() {
  std::vector<std::uint32_t> voxels(shape.voxels());
  std::iota(voxels.begin(), voxels.end(), 0U);
  return voxels;
}

TEST(Columns, HomogeneousBoxHasDepthOverSine) {
  const auto voxels = every_voxel();
  const std::vector<float> density(shape.voxels(), 5.0F);
  for (const glm::dvec3& direction : directions())
    for (float depth : optical_depths(VoxelRows(shape, voxels), density, direction))
      ASSERT_NEAR(double{depth} / (5.0 * 0.12 / direction.z), 1.0, 1e-5);
}

TEST(Columns, TransmittanceFallsExponentiallyIntoAHalfSpace) {
  const std::vector<float> density(shape.voxels(), 5.0F);
  const auto voxels = every_voxel();
  for (const glm::dvec3& direction : directions()) {
    const auto through = voxel_transmittance(VoxelRows(shape, voxels), density, direction, 0);
    for (std::uint32_t voxel : voxels) {
      const double above_m = (shape.height - shape.coordinates(voxel).z - 0.5) * shape.voxel_m;
      ASSERT_NEAR(through[voxel], std::exp(-5.0 * above_m / direction.z), 1e-5);
    }
  }
}

TEST(Columns, SkippedSlicesDoNotShadow) {
  const std::vector<float> density(shape.voxels(), 5.0F);
  const auto voxels = every_voxel();
  for (int skip : {1, 3}) {
    const auto through =
        voxel_transmittance(VoxelRows(shape, voxels), density, {0.0, 0.0, 1.0}, skip);
    for (std::uint32_t voxel : voxels) {
      const double above = shape.height - shape.coordinates(voxel).z - 0.5 - skip;
      ASSERT_NEAR(through[voxel], std::exp(-5.0 * shape.voxel_m * std::max(above, 0.0)), 1e-5)
          << "slice " << shape.coordinates(voxel).z << ", skip " << skip;
    }
  }
}

/// A solid rectangle x in [4, 10), y in [6, 14) in slice 9.
std::vector<float> roof() {
  std::vector<float> dense(shape.voxels(), 0.0F);
  for (int y = 6; y < 14; ++y)
    for (int x = 4; x < 10; ++x) dense[shape.linear(x, y, 9)] = 1e5F;
  return dense;
}

/// How deep (in voxels) a place lies inside [low, high) on the wrapped axis; negative outside.
double inside(double place, double low, double high) {
  const double middle = (low + high) / 2.0;
  const double apart = std::remainder(place - middle, shape.side);
  return (high - low) / 2.0 - std::abs(apart);
}

/// Whether the light of a place below the roof comes through it, by hand: of the patch's own roof,
/// or of those on the patches beside it. Undecided within a voxel of an edge.
enum class Under { own, others, sky, edge };
Under under(const glm::ivec3& at, const glm::dvec2& slope) {
  const glm::dvec2 place = glm::dvec2(at) + 0.5 + slope * (9.5 - (at.z + 0.5));
  const double edge = 1.0 + std::max(std::abs(slope.x), std::abs(slope.y)) / 2.0;
  const auto within = [](double along, double low, double high) {
    return (high - low) / 2.0 - std::abs(along - (low + high) / 2.0);
  };
  const double own = std::min(within(place.x, 4.0, 10.0), within(place.y, 6.0, 14.0));
  const double any = std::min(inside(place.x, 4.0, 10.0), inside(place.y, 6.0, 14.0));
  if (own > edge) return Under::own;
  if (any > edge) return Under::others;
  return any < -edge ? Under::sky : Under::edge;
}

// A shrub amid grass: its own patch has it, one of four beside it has it, too.
TEST(Columns, WhatDoesNotStandBesideAPatchShadowsItsOwnAlone) {
  const auto voxels = every_voxel();
  const Beside one_of_four{5, 0.25}, none{5, 0.0}, as_low{10, 0.25};
  int of_others = 0;
  for (const glm::dvec3& direction :
       {direction_at(25.0 * degree, 0.05), direction_at(30.0 * degree, 3.3)}) {
    const glm::dvec2 slope = glm::dvec2(direction) / direction.z;
    const auto through = [&](const Beside& beside) {
      return voxel_transmittance(VoxelRows(shape, voxels), roof(), direction, 0, beside);
    };
    const auto quarter = through(one_of_four), alone = through(none), everywhere = through(as_low);
    for (std::uint32_t voxel : voxels) {
      const glm::ivec3 at = shape.coordinates(voxel);
      if (at.z >= 9) continue;
      const Under from = under(at, slope);
      if (from == Under::edge) continue;
      of_others += from == Under::others ? 1 : 0;
      const bool own = from == Under::own, other = from == Under::others;
      ASSERT_NEAR(alone[voxel], own ? 0.0 : 1.0, 1e-5);
      ASSERT_NEAR(quarter[voxel], own ? 0.0 : other ? 0.75 : 1.0, 1e-4);
      ASSERT_NEAR(everywhere[voxel], own || other ? 0.0 : 1.0, 1e-5) << "as high as the grass";
    }
  }
  EXPECT_GT(of_others, 40);
}

// What a blade does not shadow of itself is looked for higher up, where its light may still be in
// the patch beside.
TEST(Columns, LightFromBesideIsThinnedForBladesThatDoNotShadowThemselves) {
  const auto voxels = every_voxel();
  std::vector<float> dense(shape.voxels(), 0.0F);
  for (std::uint32_t voxel : voxels)
    if (shape.coordinates(voxel).z >= 6) dense[voxel] = 500.0F;
  for (const int skip : {0, 1, 3}) {
    const auto through = voxel_transmittance(VoxelRows(shape, voxels), dense,
                                             direction_at(15.0 * degree, 0.0), skip, {2, 0.0});
    // Within a slice's two thirds of the border, light comes from below the shrubs beside.
    for (int y = 0; y < shape.side; ++y)
      EXPECT_GT(through[shape.linear(shape.side - 1, y, 2)], 0.99F) << "skip " << skip;
  }
}

TEST(Columns, RoofShadowsWhatLiesUnderIt) {
  const auto voxels = every_voxel();
  for (const glm::dvec3& direction : directions()) {
    const glm::dvec2 slope = glm::dvec2(direction) / direction.z;
    // Where in the roof's slice a ray meets it and rounding to voxels leave an edge undecided.
    const double edge =
        slope == glm::dvec2(0.0) ? 0.0 : 1.0 + std::max(std::abs(slope.x), std::abs(slope.y)) / 2.0;
    const auto through = voxel_transmittance(VoxelRows(shape, voxels), roof(), direction, 0);
    int lit = 0;
    int dark = 0;
    for (std::uint32_t voxel : voxels) {
      const glm::ivec3 at = shape.coordinates(voxel);
      if (at.z == 9) continue;
      const glm::dvec2 place = glm::dvec2(at) + 0.5 + slope * (9.0 - at.z);
      const double deep =
          at.z > 9 ? -1e9 : std::min(inside(place.x, 4.0, 10.0), inside(place.y, 6.0, 14.0));
      if (deep > edge) {
        ASSERT_LT(through[voxel], 1e-6F);
        ++dark;
      }
      if (deep < -edge) {
        ASSERT_EQ(through[voxel], 1.0F);
        ++lit;
      }
    }
    EXPECT_GT(lit, 100);
    if (direction.z > 0.5) {
      EXPECT_GT(dark, 20);
    }
  }
}

TEST(Columns, QuarterTurnOfTexelAndDirectionChangesNothing) {
  Texel texel;
  texel.shape = shape;
  for (std::uint32_t voxel = 0; voxel < shape.voxels(); ++voxel) {
    if (random_uniform({1, 2, voxel, 3}) > 0.1) continue;
    texel.voxel.push_back(voxel);
    texel.density.push_back(static_cast<float>(100.0 * random_uniform({1, 2, voxel, 4})));
  }
  const auto turned = test::quarter_turned(shape, texel.voxel);
  std::vector<float> turned_density;
  for (std::size_t from : turned.from) turned_density.push_back(texel.density[from]);
  const VoxelRows voxels(shape, texel.voxel);
  const VoxelRows turned_voxels(shape, turned.voxel);
  for (const glm::dvec3& direction : directions()) {
    const auto other = test::quarter_turned(direction);
    const auto here = voxel_transmittance(voxels, texel.density, direction, 1);
    const auto there = voxel_transmittance(turned_voxels, turned_density, other, 1);
    for (std::size_t i = 0; i < there.size(); ++i)
      ASSERT_NEAR(there[i], here[turned.from[i]], 1e-5F);
    EXPECT_NEAR(test::sum(optical_depths(voxels, texel.density, direction)) /
                    test::sum(optical_depths(turned_voxels, turned_density, other)),
                1.0, 1e-5);
  }
}

// A homogeneous layer of source radiance J shows J (1 - exp(-depth)).
TEST(Columns, RadianceOfAHomogeneousLayer) {
  const auto voxels = every_voxel();
  const std::vector<float> density(shape.voxels(), 5.0F);
  const std::vector<glm::vec3> emission(shape.voxels(), {1.0F, 0.5F, 0.0F});
  for (const glm::dvec3& direction : directions()) {
    const double seen = -std::expm1(-5.0 * 0.12 / direction.z);
    const glm::dvec3 got = mean_radiance(VoxelRows(shape, voxels), density, emission, direction);
    EXPECT_NEAR(got.r, seen, 2e-3);  // rays end when 0.1 % is left
    EXPECT_NEAR(got.g, seen / 2.0, 2e-3);
    EXPECT_EQ(got.b, 0.0);
  }
}

TEST(Columns, RefuseRaysThatDoNotRise) {
  EXPECT_THROW(Columns(shape, {1.0, 0.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace wold::grass
