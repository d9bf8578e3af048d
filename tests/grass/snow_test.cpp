#include <gtest/gtest.h>

#include "grass/ageing/patch_state.h"
#include "grass/geometry/axis.h"
#include "grass/geometry/blade_tubes.h"
#include "grass/geometry/snow_ridge.h"
#include "grass/optics/blade_picture.h"
#include "grass/texel/samples.h"
#include "grass/texel/snow_points.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

scene::Scene scene_with(DroopRule droop_rule) {
  scene::Scene scene = test::small_scene();
  scene.ageing.droop_rule = droop_rule;
  return scene;
}

/// A meadow's samples at one weathering degree, under snow.
struct Meadow {
  explicit Meadow(const scene::Scene& of, double weathering = 0.2)
      : scene(of), model(scene), samples(scene, test::small_shape(104), 0, model) {
    samples.advance_to(weathering);
  }
  scene::Scene scene;
  MeadowModel model;
  Samples samples;
};

/// What a tiled texel shows of its albedo along a direction (towards the eye, z != 0), by what it
/// covers: rays from 40 x 40 places, in steps of half a voxel.
glm::dvec3 seen_albedo(const Texel& texel, const glm::dvec3& direction) {
  const TexelShape& shape = texel.shape;
  std::vector<float> density(shape.voxels(), 0.0F);
  std::vector<glm::vec3> albedo(shape.voxels(), glm::vec3(0.0F));
  for (std::size_t i = 0; i < texel.size(); ++i) {
    density[texel.voxel[i]] = texel.density[i];
    albedo[texel.voxel[i]] = texel.albedo[i];
  }
  constexpr int rays = 40;
  glm::dvec3 sum(0.0);
  double covered = 0.0;
  for (int ray = 0; ray < rays * rays; ++ray) {
    const glm::dvec2 start = (glm::dvec2(ray % rays, ray / rays) + 0.5) / (1.0 * rays);
    glm::dvec3 at(start * (1.0 * shape.side), direction.z > 0.0 ? shape.height - 1e-6 : 0.0);
    double left = 1.0;
    for (; at.z >= 0.0 && at.z < shape.height && left > 1e-3; at -= 0.5 * direction) {
      const glm::ivec3 voxel(glm::floor(at));
      const std::uint32_t i = shape.linear(shape.wrapped(voxel.x), shape.wrapped(voxel.y), voxel.z);
      const double hidden = left * -std::expm1(-0.5 * double{density[i]} * shape.voxel_m);
      sum += hidden * glm::dvec3(albedo[i]);
      covered += hidden;
      left -= hidden;
    }
  }
  return sum / covered;
}

/// The same of opaque blades, z > 0.
glm::dvec3 seen_albedo(const BladePatch& patch, const MeadowModel& model,
                       const glm::dvec3& direction) {
  const BladePicture picture(patch, direction, 512);
  glm::dvec3 sum(0.0);
  double covered = 0.0;
  for (const BladePicture::Pixel& pixel : picture.pixels()) {
    if (pixel.blade == BladePicture::nothing) continue;
    sum += glm::dvec3(pixel.snow ? snow_albedo
                                 : model.of_species(0).albedo(patch.blades[pixel.blade],
                                                              patch.ages[pixel.blade],
                                                              double{pixel.along}));
    covered += 1.0;
  }
  return sum / covered;
}

constexpr glm::dvec3 above{0.0, 0.0, 1.0};
constexpr glm::dvec3 below{0.0, 0.0, -1.0};

TEST(Snow, MeanOfTheLumpsIsTheShare) {
  for (int level = 0; level <= 40; ++level) {
    const double fraction = level / 40.0;
    constexpr int ranks = 20000;
    double sum = 0.0;
    for (int i = 0; i < ranks; ++i) {
      const float rank = (static_cast<float>(i) + 0.5F) / ranks;
      const float thickness = lump_thickness(fraction, rank);
      EXPECT_GE(lump_thickness(std::min(fraction + 0.025, 1.0), rank), thickness);
      sum += double{thickness};
    }
    EXPECT_NEAR(sum / ranks, fraction, 1e-4);
  }
}

// Level blades, wide enough for the thickest snow: mass per leaf area is the fraction of a sixth of
// Hedstrom and Pomeroy's 6.0 (0.27 + 46 / density).
TEST(Snow, LevelBladesCarryTheMassOfTheShare) {
  for (const double fraction : {0.1, 0.25, 0.5, 0.8, 1.0}) {
    double snow_kg = 0.0;
    double leaf_m2 = 0.0;
    for (Blade blade : test::small_blades()) {
      blade.radius_m = 0.01F;
      blade.lean = static_cast<float>(test::pi / 2.0);
      BladePose pose;
      pose.snow = static_cast<float>(fraction);
      const BladeAxis axis(blade, pose);
      constexpr int steps = 200;
      for (int i = 0; i < steps; ++i) {
        // Nearer to the tip a blade is narrower than the snow is thick.
        const float along = 0.7F * (static_cast<float>(i) + 0.5F) / steps;
        const SnowRidge ridge = snow_ridge(blade, pose, along, axis.at(blade.length_m * along));
        snow_kg += 100.0 * test::pi * double{ridge.half_width_m * ridge.half_height_m};
        leaf_m2 += 2.0 * double{blade.radius_m} * (1.0 - double{along});
      }
    }
    EXPECT_NEAR(snow_kg / leaf_m2, fraction * 0.7008, 0.03 * 0.7008) << fraction;
  }
}

TEST(Snow, LiesOnWhatIsLevelNotOnWhatStands) {
  Blade blade = test::straight_blade();
  BladePose pose;
  pose.snow = 1.0F;
  const auto ridge = [&](double lean_deg) {
    blade.lean = static_cast<float>(lean_deg * test::degree);
    return snow_ridge(blade, pose, 0.3F, BladeAxis(blade, pose).at(0.3F * blade.length_m));
  };
  EXPECT_EQ(ridge(5.0).half_height_m, 0.0F);
  EXPECT_GT(ridge(25.0).half_height_m, 0.0F);
  EXPECT_GT(ridge(60.0).half_height_m, 1.5F * ridge(25.0).half_height_m);
  EXPECT_FLOAT_EQ(ridge(70.0).half_height_m, ridge(90.0).half_height_m);
  // Above the blade: its upper side is at the radius.
  EXPECT_GT(ridge(90.0).centre_m.y, blade.radius_m * 0.7F);
}

class SnowRule : public testing::TestWithParam<DroopRule> {};
INSTANTIATE_TEST_SUITE_P(Snow, SnowRule, testing::Values(DroopRule::paper, DroopRule::elastica));

TEST_P(SnowRule, BendsBladesForAsLongAsItLies) {
  const scene::Scene scene = scene_with(GetParam());
  const AgeingModel model(scene.ageing, 0.1);
  const TexelShape shape = test::small_shape();
  const std::vector<Blade> blades = test::small_blades();
  PointDynamics dynamics(model, blades, sample_points(blades, shape, 2.0, 1), /*merge=*/0.0);
  dynamics.advance_to(0.2);
  const std::vector<glm::vec3> before = dynamics.points().position_m;
  const auto mean_tip_m = [&](double snow) {
    dynamics.support_load(snow);
    double sum = 0.0;
    for (std::size_t i = 0; i < blades.size(); ++i) {
      const BladePose& pose = dynamics.poses()[i];
      sum += double{
          BladeAxis(blades[i], pose).at(blades[i].length_m * pose.length_scale).position_m.y};
    }
    return sum / static_cast<double>(blades.size());
  };
  const double free_m = mean_tip_m(0.0);
  double higher_m = free_m;
  for (const double snow : {0.25, 0.5, 0.75, 1.0}) {
    const double tip_m = mean_tip_m(snow);
    EXPECT_LT(tip_m, higher_m);
    higher_m = tip_m;
  }
  EXPECT_LT(higher_m, 0.7 * free_m);
  EXPECT_GT(higher_m, 0.05 * free_m);
  dynamics.support_load(0.0);
  EXPECT_EQ(dynamics.points().position_m, before);
}

// Every level whitens the meadow, in steps the eye takes for even, and more from above than from
// below, where the blades hide their snow.
TEST(Snow, WhitensFromAboveMoreThanFromBelow) {
  Meadow meadow(test::small_scene());
  double before = seen_albedo(meadow.samples.texel(), above).b;
  for (int level = 1; level <= snow_levels; ++level) {
    meadow.samples.support_load(PatchState(0, level).snow_fraction());
    const Texel texel = meadow.samples.texel();
    const double now = seen_albedo(texel, above).b;
    EXPECT_GT(now, before + 0.025) << level;
    EXPECT_LT(now, before + 0.14) << level;
    EXPECT_GT(now, 1.15 * seen_albedo(texel, below).b) << level;
    before = now;
  }
}

// As cameras look at a meadow; the texel's extinction is the same from all sides, that of snow on
// top of blades is not, so that it is less white than blades from straight above.
TEST(Snow, TexelAndBladesShowTheSameColour) {
  Meadow meadow(test::small_scene());
  const WitheringPatch patch(meadow.scene, meadow.model, 0);
  const auto difference = [&](const Texel& texel, double fraction, const glm::dvec3& direction) {
    return glm::length(seen_albedo(texel, direction) -
                       seen_albedo(patch.at(0.2, fraction), meadow.model, direction)) /
           std::sqrt(3.0);
  };
  for (const double fraction : {0.0, 0.1, 0.25, 0.5, 1.0}) {
    meadow.samples.support_load(fraction);
    const Texel texel = meadow.samples.texel();
    EXPECT_LT(difference(texel, fraction, direction_at(25.0 * test::degree, 0.3)), 0.025)
        << fraction;
    EXPECT_LT(difference(texel, fraction, direction_at(45.0 * test::degree, 0.3)), 0.05)
        << fraction;
    EXPECT_LT(difference(texel, fraction, above), 0.005 + 0.7 * fraction) << fraction;
  }
}

TEST(Snow, PointsAreWhiteDullAndWhereTheRidgesAre) {
  const AgeingModel model(test::small_scene().ageing, 0.1);
  const std::vector<Blade> blades = test::small_blades();
  std::vector<BladePose> poses;
  for (const Blade& blade : blades) poses.push_back(model.pose(blade, 0.2, /*snow=*/0.5));
  const Points points = snow_points(blades, poses, 0.0024);
  ASSERT_GT(points.size(), 10 * blades.size());
  EXPECT_EQ(points.blades(), blades.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points.albedo[i], snow_albedo);
    EXPECT_EQ(points.specular[i], 0.0F);
    EXPECT_GT(points.area_m2[i], 0.0F);
    EXPECT_GE(points.position_m[i].z, 0.0F);
    EXPECT_GE(points.normal[i].z, 0.15F);  // the least level place that holds snow: 10 degrees
    EXPECT_NEAR(glm::dot(points.normal[i], points.tangent[i]), 0.0F, 1e-5F);
  }
  for (BladePose& pose : poses) pose.snow = 0.0F;
  EXPECT_EQ(snow_points(blades, poses, 0.0024).size(), 0U);
}

// Snow adds tubes of its own, whiter than any leaf, after those of the blades.
TEST(Snow, LiesOnBladesInTubesOfItsOwn) {
  const scene::Scene scene = test::small_scene();
  const MeadowModel model(scene);
  const WitheringPatch patch(scene, model, 0);
  const auto tubes = [&](double snow) {
    return blade_tubes(patch.at(0.2, snow), model, test::slanting_light(), {24.0F, 0.006});
  };
  const Tubes bare = tubes(0.0);
  EXPECT_EQ(bare.count(), patch.at(0.2).blades.size());
  const Tubes some = tubes(0.1);
  const Tubes full = tubes(1.0);
  EXPECT_GT(some.count(), bare.count());
  EXPECT_GT(full.count(), some.count());
  EXPECT_LE(full.count(), 3 * bare.count());
  EXPECT_EQ(full.vertices_m.size(), full.radiance.size() * 3);
  const auto blueness = [](const Tubes& of, std::size_t begin, std::size_t end) {
    glm::vec3 sum(0.0F);
    for (std::size_t i = begin; i < end; ++i) sum += of.radiance[i];
    return sum.b / sum.g;
  };
  const std::size_t of_blades = bare.radiance.size();
  EXPECT_GT(blueness(full, of_blades, full.radiance.size()), 3.0F * blueness(full, 0, of_blades));
}

}  // namespace
}  // namespace wold::grass
