#include "grass/texel/points.h"

#include <gtest/gtest.h>

#include "grass/texel/rasterise.h"
#include "grass/texel/voxelise.h"
#include "small_meadow.h"
#include "voxelised.h"

namespace wold::grass {
namespace {

using test::small_blades;
using test::small_shape;
using test::sum;

double cones_m2(const std::vector<Blade>& blades) {
  double area = 0.0;
  for (const Blade& blade : blades) area += cone_area_m2(blade);
  return area;
}

Points fresh_points(const std::vector<Blade>& blades, const TexelShape& shape) {
  const AgeingModel model({}, 0.12);
  PointDynamics dynamics(model, blades, sample_points(blades, shape, 6.0, 5), 0.0);
  dynamics.advance_to(0.0);
  return dynamics.points();
}

// A cone of length L and foot radius r shows pi/4 L r on average: half its mantle pi r L, times the
// half of a convex body's surface that is seen, within a thin cone's (r / L)^2.
TEST(Voxelise, ACone) {
  const Blade blade = test::straight_blade();
  const double area = std::numbers::pi / 4.0 * 0.18 * 0.003;
  EXPECT_NEAR(cone_area_m2(blade), area, 1e-9);
  const TexelShape shape = small_shape(126);
  const auto voxels = voxelise_blade(blade, shape);
  double total = 0.0;
  for (const BladeVoxel& voxel : voxels) {
    total += double{voxel.area_m2};
    const float normal = glm::length(voxel.normal);
    EXPECT_TRUE(normal == 0.0F || std::abs(normal - 1.0F) < 1e-5F);
    // Normals stand on the axis.
    const glm::vec3 along(blade.heading * std::sin(blade.lean), std::cos(blade.lean));
    EXPECT_NEAR(glm::dot(voxel.normal, along), 0.0F, 1e-5F);
    // No matter beyond the cone, but for the voxel it lies in.
    const glm::vec3 centre = (glm::vec3(voxel.voxel) + 0.5F) * static_cast<float>(shape.voxel_m);
    const glm::vec3 off = glm::cross(centre - glm::vec3(blade.root_m, 0.0F), along);
    EXPECT_LT(glm::length(off), blade.radius_m + 0.87F * static_cast<float>(shape.voxel_m));
  }
  EXPECT_NEAR(total / area, 1.0, 1e-4);
}

// The vein is what lies within 0.35 of the radius, an eighth of a section: where voxels are small
// beside the blade, the area has that fraction of it.
TEST(Voxelise, AnEighthOfABladeIsVein) {
  Blade blade = test::straight_blade();
  blade.radius_m = 0.01F;
  double vein_m2 = 0.0, all_m2 = 0.0;
  for (const BladeVoxel& voxel : voxelise_blade(blade, small_shape(254))) {
    all_m2 += double{voxel.area_m2};
    if (voxel.normal == glm::vec3(0.0F)) vein_m2 += double{voxel.area_m2};
  }
  EXPECT_NEAR(vein_m2 / all_m2, 0.35 * 0.35, 0.03);
}

TEST(Voxelise, MeadowKeepsItsProjectedArea) {
  const auto blades = small_blades();
  for (int side : {30, 62})
    EXPECT_NEAR(test::voxelised(blades, small_shape(side), glm::vec3(0.3F), 0.1F).area_m2() /
                    cones_m2(blades),
                1.0, 1e-4);
}

TEST(Points, KeepTheAreaThroughSamplingAndRasterising) {
  const auto blades = small_blades();
  for (int side : {30, 62}) {
    const TexelShape shape = small_shape(side);
    const Points points = fresh_points(blades, shape);
    EXPECT_NEAR(sum(points.rest_area_m2) / cones_m2(blades), 1.0, 1e-4);
    EXPECT_NEAR(rasterise_points(points, shape).area_m2() / cones_m2(blades), 1.0, 1e-3);
  }
}

// Paper 1, section 2.3: Num = proportion * rho, rho free of units as density * voxel side.
TEST(Points, AreAsManyAsTheProportionAsksFor) {
  const auto blades = small_blades();
  const TexelShape shape = small_shape(30);
  const double depth = cones_m2(blades) / (shape.voxel_m * shape.voxel_m);
  const auto once = static_cast<double>(sample_points(blades, shape, 6.0, 5).size());
  const auto twice = static_cast<double>(sample_points(blades, shape, 12.0, 5).size());
  EXPECT_NEAR(once / (6.0 * depth), 1.0, 0.1);
  EXPECT_NEAR(twice / once, 2.0, 0.15);
}

TEST(Points, LieInsideTheirCones) {
  const auto blades = small_blades();
  const Points points = sample_points(blades, small_shape(30), 6.0, 5);
  ASSERT_EQ(points.blades(), blades.size());
  for (std::size_t b = 0; b < blades.size(); ++b)
    for (std::uint32_t i = points.blade_begin[b]; i < points.blade_begin[b + 1]; ++i) {
      const float radius = blades[b].radius_m * (1.0F - points.arc_m[i] / blades[b].length_m);
      EXPECT_LE(std::hypot(points.side_m[i], points.across_m[i]), radius * 1.0001F + 1e-7F);
      if (i > points.blade_begin[b]) {
        EXPECT_GE(points.arc_m[i], points.arc_m[i - 1]);
      }
    }
}

}  // namespace
}  // namespace wold::grass
