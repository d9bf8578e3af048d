#include "grass/mechanics/dynamics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>

#include "small_meadow.h"

namespace wold::grass {
namespace {

using scene::AgeingMotion;
using test::sum;

/// How blades droop and by what they get there.
using Way = std::tuple<DroopRule, AgeingMotion>;
constexpr Way papers_way = {DroopRule::paper, AgeingMotion::closed_form};

const AgeingModel& model(const Way& way = papers_way) {
  static std::map<Way, std::unique_ptr<AgeingModel>> models;
  std::unique_ptr<AgeingModel>& one = models[way];
  if (!one) {
    scene::Ageing ageing;
    std::tie(ageing.droop_rule, ageing.motion) = way;
    one = std::make_unique<AgeingModel>(ageing, 0.12);
  }
  return *one;
}

PointDynamics small_dynamics(double merge_distance_m, const Way& way = papers_way) {
  const auto blades = test::small_blades();
  return {model(way), blades, sample_points(blades, test::small_shape(), 6.0, 5), merge_distance_m};
}

class EveryDroopRule : public testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(Dynamics, EveryDroopRule,
                         testing::Combine(testing::Values(DroopRule::paper, DroopRule::elastica),
                                          testing::Values(AgeingMotion::closed_form,
                                                          AgeingMotion::points)));

TEST_P(EveryDroopRule, FramesStayOrthonormalAndNothingIsBelowTheGround) {
  PointDynamics dynamics = small_dynamics(0.0004, GetParam());
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

/// What a patch looks like, in a few numbers.
struct Summary {
  double area_m2 = 0.0;
  double height_m = 0.0;  ///< mean over the area
  double spread_m = 0.0;  ///< mean distance of the area from the blades' roots, on the ground
};

Summary summary(const PointDynamics& dynamics) {
  const Points& points = dynamics.points();
  Summary total;
  for (std::size_t blade = 0; blade < points.blades(); ++blade)
    for (auto i = points.blade_begin[blade]; i < points.blade_begin[blade + 1]; ++i) {
      const double area = double{points.area_m2[i]};
      const glm::vec2 from_root = glm::vec2(points.position_m[i]) - dynamics.blades()[blade].root_m;
      total.area_m2 += area;
      total.height_m += area * double{points.position_m[i].z};
      total.spread_m += area * double{glm::length(from_root)};
    }
  total.height_m /= total.area_m2;
  total.spread_m /= total.area_m2;
  return total;
}

std::size_t merged(const PointDynamics& dynamics) {
  return static_cast<std::size_t>(std::ranges::count(dynamics.points().area_m2, 0.0F));
}

// Points that come together at one step are one at the next. How many do depends on the steps; how
// much leaf there is, how high and how far from its root, does not.
TEST_P(EveryDroopRule, MergingOnMoreStepsLeavesThePatchAsItIs) {
  const auto withered = [](int steps, double merge_distance_m) {
    PointDynamics dynamics = small_dynamics(merge_distance_m, GetParam());
    for (int i = 0; i <= steps; ++i) dynamics.advance_to(0.917 * i / steps);
    return dynamics;
  };
  const Summary whole = summary(withered(12, 0.0));
  std::size_t before = 0;
  for (const int steps : {3, 48}) {
    const PointDynamics dynamics = withered(steps, 0.5 * test::small_shape().voxel_m);
    RecordProperty("merged by " + std::to_string(steps), std::to_string(merged(dynamics)));
    EXPECT_GT(merged(dynamics), before) << steps;
    before = merged(dynamics);
    const Summary left = summary(dynamics);
    EXPECT_NEAR(left.area_m2 / whole.area_m2, 1.0, 1e-4) << steps;
    EXPECT_NEAR(left.height_m / whole.height_m, 1.0, 0.005) << steps;
    EXPECT_NEAR(left.spread_m / whole.spread_m, 1.0, 0.005) << steps;
  }
}

// No step leaves a trace in what a point is afterwards, but in the frames of points that are moved,
// which follow their ways. That the steps of Algorithm 1 itself converge, blade_motion_test.cpp
// tests.
TEST_P(EveryDroopRule, WithoutMergingTheStateIsTheWeatheringsWhateverStepsLedThere) {
  const auto withered = [](int steps) {
    PointDynamics dynamics = small_dynamics(0.0, GetParam());
    for (int i = 0; i <= steps; ++i) dynamics.advance_to(0.917 * i / steps);
    return dynamics.points();
  };
  const Points once = withered(1);
  const Points often = withered(48);
  EXPECT_EQ(once.position_m, often.position_m);
  EXPECT_EQ(once.albedo, often.albedo);
  EXPECT_EQ(once.area_m2, often.area_m2);
  if (model(GetParam()).moves_points()) return;
  EXPECT_EQ(once.tangent, often.tangent);
  EXPECT_EQ(once.normal, often.normal);
}

TEST_P(EveryDroopRule, NoBladeRisesAgain) {
  // By points what dries to the end loses weight and springs back, by less than a thousandth.
  const double slack = model(GetParam()).moves_points() ? 1.001 : 1.0;
  PointDynamics dynamics = small_dynamics(0.0, GetParam());
  dynamics.advance_to(0.0);
  double height = summary(dynamics).height_m;
  for (double weathering : {0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0}) {
    dynamics.advance_to(weathering);
    EXPECT_LT(summary(dynamics).height_m, slack * height) << weathering;
    height = summary(dynamics).height_m;
  }
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

// Figure 6a by hand: the tangent of a point above the ground is the way from where its blade's
// straight shape put its foot.
TEST(Dynamics, FramesOfMovedPointsPointFromTheirFeet) {
  PointDynamics dynamics = small_dynamics(0.0, {DroopRule::elastica, AgeingMotion::points});
  for (double weathering : {0.0, 0.2, 0.4}) dynamics.advance_to(weathering);
  const Points& points = dynamics.points();
  int compared = 0;
  for (std::size_t number = 0; number < points.blades(); ++number) {
    const Blade& blade = dynamics.blades()[number];
    const glm::vec3 up = from_plane(blade, {std::sin(blade.lean), std::cos(blade.lean)});
    const glm::vec3 side = from_plane(blade, {std::cos(blade.lean), -std::sin(blade.lean)});
    const glm::vec3 across(-blade.heading.y, blade.heading.x, 0.0F);
    for (auto i = points.blade_begin[number]; i < points.blade_begin[number + 1]; ++i) {
      if (points.position_m[i].z < 0.03F) continue;
      const glm::vec3 rest =
          glm::vec3(blade.root_m, 0.0F) + points.side_m[i] * side + points.across_m[i] * across;
      const glm::vec3 foot = rest - rest.z / up.z * up;
      ASSERT_LT(glm::distance(points.tangent[i], glm::normalize(points.position_m[i] - foot)),
                0.02F);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1000);
}

// The whole patch by the paper's law, stepped and in closed form: nowhere further apart than a
// hundredth of a blade, on the mean far nearer.
TEST(Dynamics, PointsThatFollowThePapersLawGoWhereItsClosedFormPutsThem) {
  PointDynamics stepped = small_dynamics(0.0, {DroopRule::paper, AgeingMotion::points});
  PointDynamics closed = small_dynamics(0.0);
  for (double weathering : {0.0, 0.5, 1.0}) {
    stepped.advance_to(weathering);
    closed.advance_to(weathering);
    double sum = 0.0, farthest = 0.0;
    for (std::size_t i = 0; i < closed.points().size(); ++i) {
      const double apart =
          double{glm::distance(stepped.points().position_m[i], closed.points().position_m[i])};
      sum += apart;
      farthest = std::max(farthest, apart);
    }
    EXPECT_LT(sum / static_cast<double>(closed.points().size()), 0.0006) << weathering;
    EXPECT_LT(farthest, 0.004) << weathering;
  }
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
  points.transmittance.resize(4);
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
