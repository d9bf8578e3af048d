#include <gtest/gtest.h>

#include <numbers>

#include "core/files.h"
#include "grass/axis.h"
#include "grass/blade_picture.h"
#include "grass/blade_tubes.h"
#include "grass/samples.h"
#include "grass/snow_points.h"
#include "grass/snow_ridge.h"
#include "grass/time_varying_texel.h"
#include "small_meadow.h"
#include "support/temporary_folder.h"

namespace wold::grass {
namespace {

scene::Scene scene_with(const std::string& droop_rule) {
  scene::Scene scene = test::small_scene();
  scene.ageing.droop_rule = droop_rule;
  return scene;
}

/// A meadow's samples at one weathering degree, under snow.
struct Meadow {
  explicit Meadow(const scene::Scene& of, double weathering = 0.2)
      : scene(of),
        model(scene.ageing, scene.grass.specular),
        samples(scene, test::small_shape(104), 0, model) {
    samples.advance_to(weathering);
  }
  scene::Scene scene;
  AgeingModel model;
  Samples samples;
};

/// What the texel's columns show of its albedo from above or below, by what they cover; with every
/// voxel `times` as dense.
glm::dvec3 seen_albedo(const Texel& texel, bool from_above, double times) {
  std::vector<double> through(texel.shape.slice_voxels(), 1.0);
  glm::dvec3 sum(0.0);
  double covered = 0.0;
  for (std::size_t k = 0; k < texel.size(); ++k) {
    const std::size_t i = from_above ? texel.size() - 1 - k : k;
    double& left = through[texel.voxel[i] % texel.shape.slice_voxels()];
    const double hidden =
        left * -std::expm1(-times * double{texel.density[i]} * texel.shape.voxel_m);
    sum += hidden * glm::dvec3(texel.albedo[i]);
    covered += hidden;
    left -= hidden;
  }
  return sum / covered;
}

/// The same of opaque blades, from above.
glm::dvec3 seen_albedo(const BladePatch& patch, const AgeingModel& model) {
  const BladePicture picture(patch, {0.0, 0.0, 1.0}, 1024);
  glm::dvec3 sum(0.0);
  double covered = 0.0;
  for (const BladePicture::Pixel& pixel : picture.pixels()) {
    if (pixel.blade == BladePicture::nothing) continue;
    sum += glm::dvec3(pixel.snow ? snow_albedo
                                 : model.albedo(patch.blades[pixel.blade], patch.ages[pixel.blade],
                                                double{pixel.along}));
    covered += 1.0;
  }
  return sum / covered;
}

TEST(Snow, MeanOfTheLumpsIsTheShare) {
  for (int level = 0; level <= 40; ++level) {
    const double share = level / 40.0;
    constexpr int ranks = 20000;
    double sum = 0.0;
    for (int i = 0; i < ranks; ++i) {
      const float rank = (static_cast<float>(i) + 0.5F) / ranks;
      const float thickness = lump_thickness(share, rank);
      EXPECT_GE(lump_thickness(std::min(share + 0.025, 1.0), rank), thickness);
      sum += double{thickness};
    }
    EXPECT_NEAR(sum / ranks, share, 1e-4);
  }
}

// Level blades, wide enough for the thickest snow: mass per leaf area is the share of a tenth of
// Hedstrom and Pomeroy's 6.0 (0.27 + 46 / density).
TEST(Snow, LevelBladesCarryTheMassOfTheShare) {
  for (const double share : {0.1, 0.25, 0.5, 0.8, 1.0}) {
    double snow_kg = 0.0;
    double leaf_m2 = 0.0;
    for (Blade blade : test::small_blades()) {
      blade.radius_m = 0.01F;
      blade.lean = static_cast<float>(test::pi / 2.0);
      BladePose pose;
      pose.snow = static_cast<float>(share);
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
    EXPECT_NEAR(snow_kg / leaf_m2, share * 0.438, 0.03 * 0.438) << share;
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
  EXPECT_EQ(ridge(15.0).half_height_m, 0.0F);
  EXPECT_GT(ridge(40.0).half_height_m, 0.0F);
  EXPECT_GT(ridge(70.0).half_height_m, 1.5F * ridge(40.0).half_height_m);
  EXPECT_FLOAT_EQ(ridge(70.0).half_height_m, ridge(90.0).half_height_m);
  // Above the blade: its upper side is at the radius.
  EXPECT_GT(ridge(90.0).centre_m.y, blade.radius_m * 0.7F);
}

class SnowRule : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Snow, SnowRule, testing::Values("paper", "elastica"));

TEST_P(SnowRule, BendsBladesForAsLongAsItLies) {
  const scene::Scene scene = scene_with(GetParam());
  const AgeingModel model(scene.ageing, 0.1);
  const TexelShape shape = test::small_shape();
  const std::vector<Blade> blades = test::small_blades();
  PointDynamics dynamics(model, blades, sample_points(blades, shape, 2.0, 1), /*merge=*/0.0);
  dynamics.advance_to(0.2);
  const std::vector<glm::vec3> before = dynamics.points().position_m;
  double highest_before = 1.0;
  double first = 0.0;
  double last = 0.0;
  for (int level = 0; level <= 4; ++level) {
    dynamics.bear(level / 4.0);
    double tips = 0.0;
    for (std::size_t i = 0; i < blades.size(); ++i) {
      const BladePose& pose = dynamics.poses()[i];
      tips += double{
          BladeAxis(blades[i], pose).at(blades[i].length_m * pose.length_scale).position_m.y};
    }
    tips /= static_cast<double>(blades.size());
    EXPECT_LT(tips, highest_before);
    highest_before = tips;
    (level == 0 ? first : last) = tips;
  }
  EXPECT_LT(last, 0.7 * first);
  EXPECT_GT(last, 0.0);
  dynamics.bear(0.0);
  EXPECT_EQ(dynamics.points().position_m, before);
}

TEST(Snow, WhitensFromAboveMoreThanFromBelow) {
  Meadow meadow(test::small_scene());
  double above = 0.0;
  for (int level = 0; level <= 8; ++level) {
    meadow.samples.bear(PatchState(0, level).snow_share());
    const Texel texel = meadow.samples.texel();
    const double now = seen_albedo(texel, /*from_above=*/true, 1.0).b;
    const double below = seen_albedo(texel, /*from_above=*/false, 1.0).b;
    std::printf("level %d above %.4f below %.4f area %.5f\n", level, now, below, texel.area_m2());
    if (level > 0) {
      EXPECT_GT(now, above + 0.01) << level;
      EXPECT_GT(now, 1.1 * below) << level;
    }
    above = now;
  }
}

TEST(Snow, TexelAndBladesShowTheSameColour) {
  Meadow meadow(test::small_scene());
  const WitheringPatch patch(meadow.scene, meadow.model, 0);
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    meadow.samples.bear(share);
    const glm::dvec3 texel = seen_albedo(meadow.samples.texel(), /*from_above=*/true, 1.0);
    const glm::dvec3 blades = seen_albedo(patch.at(0.2, share), meadow.model);
    std::printf("share %.2f texel %.3f %.3f %.3f blades %.3f %.3f %.3f mean %.3f\n", share, texel.r,
                texel.g, texel.b, blades.r, blades.g, blades.b,
                double{mean_albedo(patch.at(0.2, share), meadow.model).b});
  }
}

}  // namespace
}  // namespace wold::grass
