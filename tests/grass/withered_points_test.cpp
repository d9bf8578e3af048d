#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "grass/ageing/ageing_curves.h"
#include "grass/geometry/point_tubes.h"
#include "grass/mechanics/mechanics.h"
#include "grass/texel/blade_patch.h"
#include "grass/texel/samples.h"
#include "small_meadow.h"

/// What becomes of a blade's points, against plain geometry.
namespace wold::grass {
namespace {

AgeingModel model_of(const scene::Ageing& ageing) { return AgeingModel(ageing, 0.12); }

PointDynamics points_of(const AgeingModel& model, const std::vector<Blade>& blades,
                        double merge_distance_m = 0.0) {
  return {model, blades, sample_points(blades, test::small_shape(), 6.0, 5), merge_distance_m};
}

// Tissues that shrink alike keep a blade's shape: its area goes with the square of the side of a
// volume that lost the strain's share.
TEST(WitheredPoints, LoseAreaAsTheSquareOfTheirLength) {
  scene::Ageing ageing;
  ageing.vein_shrinkage = ageing.mesophyll_shrinkage;
  const AgeingModel model = model_of(ageing);
  PointDynamics dynamics = points_of(model, test::small_blades());
  dynamics.advance_to(1.0);
  const Points& points = dynamics.points();
  const double water_lost = 1.0 - load_curve(CurveKind::water, ageing.water)(1.0);
  const double strain = tissue_state(ageing, water_lost).strain_vein;
  ASSERT_GT(strain, 0.2);
  EXPECT_NEAR(test::sum(points.area_m2) / test::sum(points.rest_area_m2),
              std::pow(1.0 - strain, 2.0 / 3.0), 1e-5);
}

// Normals look from the vein outwards, whichever way the blade leans and turns.
TEST(WitheredPoints, HaveNormalsThatLookFromTheAxisToThem) {
  const AgeingModel model = model_of({});
  for (const double weathering : {0.0, 0.6}) {
    PointDynamics dynamics = points_of(model, test::small_blades());
    dynamics.advance_to(weathering);
    const Points& points = dynamics.points();
    int looked_at = 0;
    for (std::size_t number = 0; number < points.blades(); ++number) {
      const Blade& blade = dynamics.blades()[number];
      const BladePose& pose = dynamics.poses()[number];
      const BladeAxis axis(blade, pose);
      for (auto i = points.blade_begin[number]; i < points.blade_begin[number + 1]; ++i) {
        if (points.vein[i] != 0 || points.position_m[i].z == 0.0F) continue;
        const glm::vec3 from_axis_m =
            points.position_m[i] - on_patch_m(blade, axis.at(points.arc_m[i] * pose.length_scale));
        if (glm::length(from_axis_m) < 0.5F * blade.radius_m) continue;
        ASSERT_GT(glm::dot(points.normal[i], glm::normalize(from_axis_m)), 0.9F) << i;
        ++looked_at;
      }
    }
    EXPECT_GT(looked_at, 1000);
  }
}

/// Pairs of one blade's points of one tissue that are nearer to each other than that.
int near_pairs(const Points& points, double distance_m) {
  int pairs = 0;
  for (std::size_t blade = 0; blade < points.blades(); ++blade)
    for (auto i = points.blade_begin[blade]; i < points.blade_begin[blade + 1]; ++i)
      for (auto j = i + 1; j < points.blade_begin[blade + 1]; ++j)
        if (points.vein[i] == points.vein[j] && points.area_m2[i] > 0.0F &&
            points.area_m2[j] > 0.0F &&
            double{glm::distance(points.position_m[i], points.position_m[j])} < distance_m)
          ++pairs;
  return pairs;
}

// What a texel cannot tell apart, points within a tenth of its voxels, becomes one.
TEST(Samples, MergeWhatTheTexelCannotTellApart) {
  scene::Scene scene = test::small_scene();
  scene.grass.points_per_voxel_face = 12.0;
  const MeadowModel model(scene);
  const double near_m = 0.1 * test::small_shape().voxel_m;
  Samples samples(scene, test::small_shape(), 0, model);
  for (const double weathering : {0.0, 0.5, 1.0}) samples.advance_to(weathering);
  const PointDynamics& merged = samples.all().front();

  PointDynamics apart(model.of_species(0), merged.blades(),
                      sample_points(merged.blades(), test::small_shape(), 12.0, 5), 0.0);
  apart.advance_to(1.0);
  const int before = near_pairs(apart.points(), near_m);
  ASSERT_GT(before, 100);
  EXPECT_LT(near_pairs(merged.points(), near_m), before / 10);
  EXPECT_NEAR(test::sum(merged.points().rest_area_m2) / test::sum(apart.points().rest_area_m2), 1.0,
              1e-4);
}

// A blade of another sample throws its shadow, too: two walls of blades as the sun sees them, the
// first a sample for itself.
TEST(PointTubes, OfOneSampleShadeAnothers) {
  scene::Ageing green = test::small_scene().ageing;
  green.chlorophyll_ug_cm2 = 31.5;
  green.carotenoid_ug_cm2 = 3.5;
  const AgeingModel model = model_of(green);
  Blade front = test::straight_blade();
  front.lean = 0.0F;
  front.root_m = {0.15F, 0.125F};
  front.radius_m = 0.02F;
  Blade behind = front;
  behind.root_m = {0.10F, 0.125F};
  behind.radius_m = 0.001F;
  Lighting lighting = test::slanting_light();
  lighting.sun_direction = direction_at(45.0 * test::degree, 0.0);
  for (glm::vec3& radiance : lighting.sky_radiance) radiance = glm::vec3(0.0F);
  std::vector<PointDynamics> samples;
  BladePatch patch{test::small_scene().grass.patch_m, {}, {}, {}};
  for (const Blade& blade : {front, behind}) {
    samples.push_back(points_of(model, {blade}));
    samples.back().advance_to(0.0);
    patch.blades.push_back(blade);
    patch.ages.push_back(AgeingModel::blade_age(blade, 0.0));
    patch.poses.push_back(model.pose(blade, patch.ages.back()));
  }
  const Tubes tubes = point_tubes(patch, samples, lighting, {24.0F, 0.006}, 0.004);
  const std::size_t of_front = samples.front().points().size();
  const Points& thin = samples.back().points();
  int in_shadow = 0;
  for (std::size_t i = 0; i < thin.size(); ++i) {
    if (thin.position_m[i].z > 0.11F || thin.position_m[i].z < 0.01F) continue;
    EXPECT_LT(tubes.radiance[3 * (of_front + i)].g, 3e-4F) << thin.position_m[i].z;
    ++in_shadow;
  }
  EXPECT_GT(in_shadow, 3);
}

// A blade is a cone in the texel: the fraction of its area beyond `along` falls as 1 - along.
TEST(BladePatch, HasTheMeanAlbedoOfItsArea) {
  scene::Scene scene = test::small_scene();
  const MeadowModel model(scene);
  const BladePatch patch = WitheringPatch(scene, model, 0).at(0.5);
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (std::size_t i = 0; i < patch.blades.size(); ++i)
    for (double along = 0.005; along < 1.0; along += 0.01) {
      const double weight =
          (1.0 - along) * double{patch.blades[i].radius_m * patch.blades[i].length_m};
      sum += weight *
             glm::dvec3(model.of(patch.blades[i]).albedo(patch.blades[i], patch.ages[i], along));
      weights += weight;
    }
  const glm::dvec3 apart = glm::dvec3(mean_albedo(patch, model)) / (sum / weights) - 1.0;
  EXPECT_LT(glm::length(apart), 0.02);
}

}  // namespace
}  // namespace wold::grass
