#include "grass/dynamics.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grass/voxelise.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

using test::sum;

const AgeingModel& model() {
  static const AgeingModel model({}, 0.12);
  return model;
}

PointDynamics small_dynamics(double merge_distance_m) {
  const auto blades = test::small_blades();
  return {model(), blades, sample_points(blades, test::small_shape(), 6.0, 5), merge_distance_m};
}

TEST(Dynamics, FramesStayOrthonormalAndNothingIsBelowTheGround) {
  PointDynamics dynamics = small_dynamics(0.0004);
  for (double weathering : {0.0, 0.3, 0.6, 1.0}) {
    dynamics.advance_to(weathering);
    const Points& points = dynamics.points();
    ASSERT_GT(points.size(), 1000U);
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_NEAR(glm::length(points.tangent[i]), 1.0F, 1e-5F);
      ASSERT_NEAR(glm::dot(points.tangent[i], points.normal[i]), 0.0F, 1e-5F);
      const float normal = glm::length(points.normal[i]);
      ASSERT_TRUE(points.vein[i] != 0 ? normal == 0.0F : std::abs(normal - 1.0F) < 1e-5F);
      ASSERT_GE(points.position_m[i].z, 0.0F);
    }
  }
}

TEST(Dynamics, StateDoesNotDependOnTheStepsBetween) {
  PointDynamics once = small_dynamics(0.0);
  PointDynamics often = small_dynamics(0.0);
  for (double weathering : {0.0, 1.0}) once.advance_to(weathering);
  for (double weathering : {0.0, 0.3, 0.7, 1.0}) often.advance_to(weathering);
  EXPECT_EQ(once.points().position_m, often.points().position_m);
  EXPECT_EQ(once.points().tangent, often.points().tangent);
  EXPECT_EQ(once.points().normal, often.points().normal);
  EXPECT_EQ(once.points().albedo, often.points().albedo);
  EXPECT_EQ(once.points().area_m2, often.points().area_m2);
}

TEST(Dynamics, WitheringLowersShrinksAndDulls) {
  PointDynamics dynamics = small_dynamics(0.0);
  const auto mean_height = [&] {
    double height = 0.0;
    for (const glm::vec3& place : dynamics.points().position_m) height += double{place.z};
    return height / static_cast<double>(dynamics.points().size());
  };
  dynamics.advance_to(0.0);
  const double fresh_height = mean_height();
  const double fresh_area = sum(dynamics.points().area_m2);
  EXPECT_NEAR(fresh_area / sum(dynamics.points().rest_area_m2), 1.0, 1e-5);
  EXPECT_NEAR(dynamics.points().specular[0], 0.12F, 1e-6F);
  dynamics.advance_to(1.0);
  EXPECT_LT(mean_height(), 0.9 * fresh_height);
  // Between the shrinkage of vein and of mesophyll: length times width.
  const BladePose& pose = dynamics.poses()[0];
  const double area = sum(dynamics.points().area_m2) / fresh_area;
  EXPECT_GT(area, double{pose.length_scale} * double{pose.mesophyll_width});
  EXPECT_LT(area, double{pose.length_scale} * double{pose.vein_width});
  EXPECT_LT(dynamics.points().specular[0], 0.12F);
}

TEST(AgeingModel, AgesAreMonotoneAndMeetAtTheEnds) {
  Blade blade = test::straight_blade();
  for (float onset : {-2.0F, -0.2F, 0.0F, 0.2F, 2.0F}) {
    blade.onset = onset;
    EXPECT_DOUBLE_EQ(AgeingModel::blade_age(blade, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(AgeingModel::blade_age(blade, 1.0), 1.0);
    for (int i = 0; i < 100; ++i)
      EXPECT_LT(AgeingModel::blade_age(blade, i / 100.0),
                AgeingModel::blade_age(blade, (i + 1) / 100.0));
  }
  EXPECT_GT(AgeingModel::local_age(0.5, 1.0), AgeingModel::local_age(0.5, 0.0));
}

/// A straight blade with two mesophyll points 0.2 mm apart, a vein point beside them, one far away.
Points four_points() {
  Points points;
  points.blade_begin = {0, 4};
  points.arc_m = {0.1F, 0.1001F, 0.1002F, 0.15F};
  points.side_m = {0.0010F, 0.0F, 0.0010F, 0.0F};
  points.across_m = {0.0002F, 0.0F, 0.0004F, 0.0003F};
  points.rest_area_m2 = {3e-6F, 1e-6F, 1e-6F, 1e-6F};
  points.vein = {0, 1, 0, 0};
  points.position_m.resize(4);
  points.tangent.resize(4);
  points.normal.resize(4);
  points.albedo.resize(4);
  points.specular.resize(4);
  points.area_m2 = points.rest_area_m2;
  return points;
}

/// Points that were not merged into another one.
std::ptrdiff_t standing(const Points& points) {
  return std::count_if(points.area_m2.begin(), points.area_m2.end(),
                       [](float area) { return area > 0.0F; });
}

TEST(Dynamics, MergesNearPointsOfOneTissue) {
  const auto advanced = [](double merge_distance_m, double weathering) {
    PointDynamics dynamics(model(), {test::straight_blade()}, four_points(), merge_distance_m);
    dynamics.advance_to(weathering);
    return dynamics.points();
  };
  const Points apart = advanced(0.0, 0.5);
  const Points merged = advanced(0.0015, 0.5);
  ASSERT_EQ(apart.size(), 4U);
  EXPECT_EQ(standing(merged), 3);
  EXPECT_EQ(merged.area_m2[2], 0.0F);
  EXPECT_FLOAT_EQ(merged.area_m2[0], apart.area_m2[0] + apart.area_m2[2]);
  EXPECT_NEAR(sum(merged.area_m2) / sum(apart.area_m2), 1.0, 1e-6);
  EXPECT_NEAR(sum(merged.rest_area_m2) / sum(apart.rest_area_m2), 1.0, 1e-6);
  const auto mean = [](const glm::vec3& a, const glm::vec3& b) { return 0.75F * a + 0.25F * b; };
  EXPECT_LT(glm::distance(merged.position_m[0], mean(apart.position_m[0], apart.position_m[2])),
            1e-7F);
  EXPECT_LT(glm::distance(merged.albedo[0], mean(apart.albedo[0], apart.albedo[2])), 1e-6F);
  EXPECT_EQ(merged.position_m[1], apart.position_m[1]);
  EXPECT_EQ(merged.position_m[3], apart.position_m[3]);
}

TEST(Dynamics, MergingManyKeepsTheArea) {
  PointDynamics apart = small_dynamics(0.0);
  PointDynamics merging = small_dynamics(0.004);
  for (double weathering : {0.0, 0.5, 1.0}) {
    apart.advance_to(weathering);
    merging.advance_to(weathering);
  }
  EXPECT_LT(standing(merging.points()), standing(apart.points()) / 2);
  EXPECT_NEAR(sum(merging.points().rest_area_m2) / sum(apart.points().rest_area_m2), 1.0, 1e-5);
}

}  // namespace
}  // namespace wold::grass
