#include "grass/texel/samples.h"

#include <gtest/gtest.h>

#include "core/vdb_dense.h"
#include "grass/ageing/ageing_curves.h"
#include "grass/texel/blade_patch.h"
#include "grass/texel/rasterise.h"
#include "grass/texel/texel_file.h"
#include "grass/texel/time_varying_texel.h"
#include "scene/key_frames.h"
#include "small_meadow.h"
#include "support/temporary_folder.h"

namespace wold::grass {
namespace {

scene::Scene mingled(const std::vector<std::string>& rates, int blades) {
  scene::Scene scene = test::small_scene();
  scene.grass.blades = blades;
  for (const std::string& rate : rates) scene.grass.mingle.push_back({rate, {}});
  return scene;
}

/// The samples of a scene on the small texel, and what drives them.
struct Meadow {
  explicit Meadow(const scene::Scene& scene)
      : model(scene), samples(scene, test::small_shape(), 0, model) {}
  MeadowModel model;
  Samples samples;
};

Texel texel_of(const PointDynamics& sample) {
  return rasterise_points(sample.points(), test::small_shape());
}

/// Red over green of the mean albedo: below 1 green, above 1 yellow.
double yellowness(const Texel& texel) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < texel.size(); ++i)
    sum += double{texel.density[i]} * glm::dvec3(texel.albedo[i]);
  return sum.r / sum.g;
}

// Section 4.1: seven samples of 100 blades make a patch of 700.
TEST(Samples, OfAHundredBladesSumUp) {
  Meadow meadow(mingled({"early", "steady", "late", "slow", "sudden", "evergreen", "steady"}, 700));
  meadow.samples.advance_to(0.4);
  ASSERT_EQ(meadow.samples.all().size(), 7U);
  double area_m2 = 0.0;
  for (const PointDynamics& sample : meadow.samples.all()) {
    EXPECT_EQ(sample.blades().size(), 100U);
    area_m2 += texel_of(sample).area_m2();
  }
  EXPECT_NEAR(meadow.samples.texel().area_m2() / area_m2, 1.0, 1e-6);
}

TEST(Samples, ShareTheBladesOutEvenly) {
  Meadow meadow(mingled({"early", "late", "steady"}, 11));
  const auto blades = [&](std::size_t i) { return meadow.samples.all()[i].blades().size(); };
  EXPECT_EQ(blades(0), 4U);
  EXPECT_EQ(blades(1), 4U);
  EXPECT_EQ(blades(2), 3U);
}

// ageing.merge_distance is in voxels: none at 0, most points within a whole one of another.
TEST(Samples, MergePointsWithinTheScenesDistance) {
  const auto left = [](double voxels) {
    scene::Scene scene = mingled({}, 30);
    scene.ageing.merge_distance_voxels = voxels;
    Meadow meadow(scene);
    meadow.samples.advance_to(0.3);
    std::ptrdiff_t standing = 0;
    double area_m2 = 0.0;
    for (float area : meadow.samples.all()[0].points().area_m2) {
      standing += area > 0.0F ? 1 : 0;
      area_m2 += double{area};
    }
    return std::pair{standing, area_m2};
  };
  const auto none = left(0.0), few = left(0.4), many = left(1.0);
  EXPECT_EQ(static_cast<std::size_t>(none.first), Meadow(mingled({}, 30)).samples.points());
  EXPECT_LT(few.first, none.first);
  EXPECT_LT(many.first, few.first);
  EXPECT_LT(many.first, none.first * 2 / 3);
  EXPECT_NEAR(many.second / none.second, 1.0, 1e-3);
}

// The texel's points and the meshes of the blades are one meadow.
TEST(Samples, StepToWhereTheBladesOfThePatchAre) {
  for (const DroopRule rule : {DroopRule::paper, DroopRule::elastica}) {
    scene::Scene scene = mingled({"early", "late"}, 40);
    scene.ageing.motion = scene::AgeingMotion::points;
    scene.ageing.droop_rule = rule;
    Meadow meadow(scene);
    for (double weathering : {0.1, 0.45, 0.8}) {
      meadow.samples.advance_to(weathering);
      const BladePatch patch = WitheringPatch(scene, meadow.model, 0).at(weathering);
      std::size_t i = 0;
      for (const PointDynamics& sample : meadow.samples.all())
        for (const BladePose& pose : sample.poses()) {
          ASSERT_TRUE(pose.vein && patch.poses[i].vein);
          ASSERT_EQ(*pose.vein, *patch.poses[i].vein);
          ++i;
        }
      EXPECT_EQ(i, patch.poses.size());
    }
  }
}

TEST(Samples, HaveBladesOfTheirOwn) {
  scene::Scene scene = mingled({"steady", "steady"}, 200);
  const auto first = sample_blades(scene, 0, 0);
  const auto second = sample_blades(scene, 0, 1);
  const auto variant = sample_blades(scene, 1, 0);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_NE(first[i].root_m, second[i].root_m);
    EXPECT_NE(second[i].root_m, variant[i].root_m);
  }
  // The first sample's are those of a patch that has as many and is not mingled.
  scene = mingled({}, 100);
  const auto alone = sample_blades(scene, 0, 0);
  ASSERT_EQ(alone.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(alone[i].root_m, first[i].root_m);
    EXPECT_EQ(alone[i].length_m, first[i].length_m);
  }
}

TEST(Samples, AgeAtRatesOfTheirOwn) {
  Meadow meadow(mingled({"early", "late"}, 200));
  meadow.samples.advance_to(0.5);
  const double early = yellowness(texel_of(meadow.samples.all()[0]));
  const double late = yellowness(texel_of(meadow.samples.all()[1]));
  EXPECT_GT(early, 1.1);
  EXPECT_LT(late, 0.7);
  // Green beside yellow in one texel: both kinds of voxels are many.
  const Texel both = meadow.samples.texel();
  std::size_t green = 0;
  std::size_t yellow = 0;
  for (const glm::vec3& albedo : both.albedo) {
    green += albedo.r < 0.8F * albedo.g ? 1 : 0;
    yellow += albedo.r > 1.1F * albedo.g ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(green), 0.25 * static_cast<double>(both.size()));
  EXPECT_GT(static_cast<double>(yellow), 0.25 * static_cast<double>(both.size()));
  // wd_i = Mg_i(wd): a sample is where a meadow without mingling is at that degree.
  scene::Scene alone = mingled({}, 100);
  Meadow steady(alone);
  steady.samples.advance_to(load_curve(CurveKind::rate, {"early", {}})(0.5));
  EXPECT_EQ(texel_of(steady.samples.all()[0]).albedo, texel_of(meadow.samples.all()[0]).albedo);
}

/// Makes one variant at all its key frames.
TimeVaryingTexel made(const scene::Scene& scene, const std::filesystem::path& folder) {
  TimeVaryingTexel texel(scene, {test::slanting_light()}, folder);
  TexelDemand demand;
  for (int k = 0; k < static_cast<int>(scene::key_frames(scene).size()); ++k)
    demand[0][k] = {{0, {0}}, {1, {2}}};
  SilentProgress progress;
  texel.generate(demand, progress);
  return texel;
}

TEST(Samples, OneSteadySampleIsTheMeadowWithoutMingling) {
  scene::Scene scene = test::small_scene();
  scene.grass.key_frames = {0.0, 0.083, 0.3, 0.917, 1.0};
  const wold::test::TemporaryFolder plain_folder("samples_plain");
  const wold::test::TemporaryFolder steady_folder("samples_steady");
  const TimeVaryingTexel plain = made(scene, plain_folder.path());
  scene.grass.mingle = {{"steady", {}}};
  const TimeVaryingTexel steady = made(scene, steady_folder.path());
  ASSERT_EQ(plain.shape(), steady.shape());
  const glm::ivec3 size(30, 30, plain.lod_shape(1).height);
  for (int k = 0; k < static_cast<int>(scene::key_frames(scene).size()); ++k) {
    const Texel a = read_texel(plain.texel_path(0, k));
    const Texel b = read_texel(steady.texel_path(0, k));
    EXPECT_EQ(a.voxel, b.voxel);
    EXPECT_EQ(a.density, b.density);
    EXPECT_EQ(a.tangent, b.tangent);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.albedo, b.albedo);
    EXPECT_EQ(a.specular, b.specular);
    const auto level = [&](const TimeVaryingTexel& texel) {
      return read_dense_vectors(texel.volume_path(0, k, 1), "emission_q2", glm::ivec3(1), size);
    };
    EXPECT_EQ(level(plain), level(steady));
    EXPECT_NE(file_content(plain.texel_path(0, k)), file_content(steady.texel_path(0, k)))
        << "texels of another scene must be made anew";
  }
}

}  // namespace
}  // namespace wold::grass
