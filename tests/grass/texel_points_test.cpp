#include "grass/texel/texel_points.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "core/vdb_file.h"
#include "grass/texel/foreign_texel.h"
#include "grass/texel/rasterise.h"
#include "grass/texel/samples.h"
#include "grass/texel/texel_file.h"
#include "small_meadow.h"
#include "support/temporary_folder.h"

namespace wold::grass {
namespace {

namespace fs = std::filesystem;
using test::sum;

const AgeingModel& model() {
  static const AgeingModel shared(scene::Ageing{}, 0.12);
  return shared;
}

/// A fresh meadow's texel, made from cones.
Texel meadow_texel() {
  const auto blades = test::small_blades();
  PointDynamics dynamics(model(), blades, sample_points(blades, test::small_shape(), 6.0, 5), 0.0);
  dynamics.advance_to(0.0);
  return rasterise_points(dynamics.points(), test::small_shape());
}

SampledTexel sampled(const Texel& texel, double points_per_voxel_face = 6.0) {
  scene::Grass grass;
  grass.points_per_voxel_face = points_per_voxel_face;
  return sample_texel(texel, grass, scene::Ageing{}, 11);
}

/// Area by height, in layers of four voxels.
std::vector<double> profile(const Texel& texel) {
  std::vector<double> layers(static_cast<std::size_t>(texel.shape.height / 4 + 1));
  for (std::size_t i = 0; i < texel.size(); ++i)
    layers[static_cast<std::size_t>(texel.shape.coordinates(texel.voxel[i]).z / 4)] +=
        double{texel.density[i]} * texel.shape.voxel_volume_m3();
  return layers;
}

/// A ball of fog in a file, cubes of `voxel` a side; what a stranger may bring.
openvdb::FloatGrid::Ptr ball(double voxel) {
  auto grid = openvdb::FloatGrid::create(0.0F);
  grid->setName("density");
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
  auto accessor = grid->getAccessor();
  for (int z = -9; z <= 9; ++z)
    for (int y = -9; y <= 9; ++y)
      for (int x = -9; x <= 9; ++x)
        if (x * x + y * y + z * z <= 81)
          accessor.setValue(openvdb::Coord(x - 40, y + 7, z + 100),
                            static_cast<float>(0.3 / voxel));
  return grid;
}

class TexelPoints : public testing::Test {
 protected:
  fs::path file(const openvdb::GridPtrVec& grids) const {
    const fs::path path = folder_.path() / "volume.vdb";
    write_vdb(path, grids);
    return path;
  }
  std::string refusal(const openvdb::GridPtrVec& grids) const {
    try {
      read_any_texel(file(grids), "grass.from_texel");
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }
  wold::test::TemporaryFolder folder_{"texel_points"};
};

TEST_F(TexelPoints, RoundTripKeepsAreaAndProfile) {
  const Texel texel = meadow_texel();
  const SampledTexel points = sampled(texel);
  EXPECT_NEAR(sum(points.points.rest_area_m2) / texel.area_m2(), 1.0, 1e-4);
  // They stand where the texel has them: a model that bends nothing.
  scene::Ageing stiff;
  stiff.onset_spread = 0.0;
  const AgeingModel fresh(stiff, 0.12);
  PointDynamics dynamics(fresh, points.blades, points.points, 0.0);
  dynamics.advance_to(0.0);
  const Texel again = rasterise_points(dynamics.points(), texel.shape);
  EXPECT_NEAR(again.area_m2() / texel.area_m2(), 1.0, 0.01);
  // Points spread over the voxels around them, and what stood a little higher stands on a straight
  // blade: layers differ by less than a hundredth of all.
  const auto before = profile(texel), after = profile(again);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(after[i], before[i], 0.007 * texel.area_m2()) << i;
  // Fibres lie along the blades that they came from.
  double along = 0.0, all = 0.0;
  const std::size_t count = std::min(again.size(), texel.size());
  for (std::size_t i = 0, j = 0; i < count && j < texel.size(); ++i) {
    while (j < texel.size() && texel.voxel[j] < again.voxel[i]) ++j;
    if (j == texel.size() || texel.voxel[j] != again.voxel[i]) continue;
    const double weight = double{again.density[i]};
    along += weight * std::abs(double{glm::dot(again.tangent[i], texel.tangent[j])});
    all += weight;
  }
  EXPECT_GT(along / all, 0.95);
}

TEST_F(TexelPoints, AgeLikeAnyPoints) {
  const SampledTexel points = sampled(meadow_texel());
  for (const auto motion : {scene::AgeingMotion::closed_form, scene::AgeingMotion::points}) {
    scene::Ageing ageing;
    ageing.motion = motion;
    const AgeingModel withering(ageing, 0.12);
    PointDynamics dynamics(withering, points.blades, points.points, 0.0);
    const auto height = [&] {
      double total = 0.0;
      for (std::size_t i = 0; i < dynamics.points().size(); ++i)
        total += double{dynamics.points().area_m2[i]} * double{dynamics.points().position_m[i].z};
      return total / sum(dynamics.points().area_m2);
    };
    dynamics.advance_to(0.0);
    const double fresh_m = height();
    dynamics.advance_to(1.0);
    EXPECT_LT(height(), 0.8 * fresh_m) << scene::word_of(motion);
    const glm::vec3 straw = dynamics.points().albedo.front();
    EXPECT_GT(straw.r, straw.g) << scene::word_of(motion);
  }
}

TEST_F(TexelPoints, ReadsItsOwnTexels) {
  const Texel texel = meadow_texel();
  const fs::path path = folder_.path() / "own.vdb";
  write_texel(path, texel, "test");
  const Texel own = read_texel(path);
  const Texel any = read_any_texel(path, "grass.from_texel");
  EXPECT_EQ(any.shape, own.shape);
  EXPECT_EQ(any.voxel, own.voxel);
  EXPECT_EQ(any.density, own.density);
  EXPECT_EQ(any.albedo, own.albedo);
  const Texel larger = fitted_to_patch(any, 2.0 * any.shape.patch_m());
  EXPECT_NEAR(larger.area_m2() / any.area_m2(), 4.0, 1e-4);
}

TEST_F(TexelPoints, ReadsAnyFogVolume) {
  const Texel texel = fitted_to_patch(read_any_texel(file({ball(2.5)}), "grass.from_texel"), 0.19);
  EXPECT_EQ(texel.shape.side, 19);
  EXPECT_EQ(texel.shape.height, 19);
  EXPECT_NEAR(texel.shape.voxel_m, 0.01, 1e-9);
  EXPECT_NEAR(double{texel.density.front()} * texel.shape.voxel_m, 0.3, 1e-3);
  EXPECT_TRUE(texel.albedo.empty());
  const SampledTexel points = sampled(texel, 20.0);
  EXPECT_NEAR(sum(points.points.rest_area_m2) / texel.area_m2(), 1.0, 0.01);
  for (const Blade& blade : points.blades) {
    EXPECT_EQ(blade.lean, 0.0F);
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(blade.root_m, glm::vec2(0.0F))));
    EXPECT_TRUE(glm::all(glm::lessThan(blade.root_m, glm::vec2(0.19F))));
  }
}

TEST_F(TexelPoints, AreTheColourThatTheTexelHas) {
  auto density = ball(1.0);
  auto colour = openvdb::Vec3SGrid::create();
  colour->setName("albedo");
  for (auto it = density->cbeginValueOn(); it; ++it)
    colour->getAccessor().setValue(it.getCoord(), openvdb::Vec3s(0.6F, 0.1F, 0.2F));
  const SampledTexel points =
      sampled(fitted_to_patch(read_any_texel(file({density, colour}), "k"), 0.19));
  const glm::vec3 fresh = model().albedo(points.blades.front(), 0.0, 0.5);
  EXPECT_LT(glm::distance(fresh, {0.6F, 0.1F, 0.2F}), 1e-3F);
  Blade plain = points.blades.front();
  plain.own_albedo.reset();
  EXPECT_LT(glm::distance(model().albedo(points.blades.front(), 1.0, 0.5),
                          model().albedo(plain, 1.0, 0.5)),
            1e-6F);
}

TEST_F(TexelPoints, AreTheSameForTheSameSeed) {
  const Texel texel = meadow_texel();
  const SampledTexel a = sampled(texel), b = sampled(texel);
  EXPECT_EQ(a.points.arc_m, b.points.arc_m);
  const SampledTexel other = sample_texel(texel, scene::Grass{}, scene::Ageing{}, 12);
  EXPECT_NE(a.points.arc_m, other.points.arc_m);
}

TEST_F(TexelPoints, RefusesWhatIsNoTexel) {
  auto emission = openvdb::Vec3SGrid::create();
  emission->setName("emission");
  EXPECT_NE(refusal({emission}).find("the grids \"emission\" (vec3s), expected a float grid"),
            std::string::npos)
      << refusal({emission});
  auto empty = openvdb::FloatGrid::create(0.0F);
  empty->setName("density");
  EXPECT_NE(refusal({empty}).find("expected a volume with matter"), std::string::npos);
  auto surface = ball(1.0);
  surface->setGridClass(openvdb::GRID_LEVEL_SET);
  EXPECT_NE(refusal({surface}).find("expected a fog volume"), std::string::npos);
  auto wide = ball(1.0);
  wide->tree().setValue(openvdb::Coord(5000, 0, 0), 1.0F);
  EXPECT_NE(refusal({wide}).find("at most 1024 along an edge"), std::string::npos);
  auto huge = ball(1.0);
  huge->fill(openvdb::CoordBBox(openvdb::Coord(0), openvdb::Coord(4095)), 1.0F);
  EXPECT_NE(refusal({huge}).find("expected at most 20000000"), std::string::npos);
  auto broken = ball(1.0);
  broken->tree().setValue(openvdb::Coord(-40, 7, 100), std::nanf(""));
  EXPECT_NE(refusal({broken}).find("expected numbers"), std::string::npos);
  auto flat = ball(1.0);
  flat->setTransform(std::make_shared<openvdb::math::Transform>(
      std::make_shared<openvdb::math::ScaleMap>(openvdb::Vec3d(1.0, 1.0, 2.0))));
  EXPECT_NE(refusal({flat}).find("expected cubic voxels"), std::string::npos);
  EXPECT_THROW(read_any_texel(folder_.path() / "none.vdb", "k"), FileError);
}

TEST_F(TexelPoints, DrivesThePatchesOfAScene) {
  scene::Scene scene = test::small_scene();
  const fs::path path = folder_.path() / "meadow.vdb";
  const Texel texel = meadow_texel();
  write_texel(path, texel, "test");
  scene.grass.from_texel = path.string();
  const MeadowModel withering(scene);
  Samples samples(scene, test::small_shape(), 0, withering);
  samples.advance_to(0.0);
  EXPECT_NEAR(samples.texel().area_m2() / texel.area_m2(), 1.0, 0.01);
  EXPECT_EQ(sample_blades(scene, 0, 0).size(), samples.all()[0].blades().size());
}

}  // namespace
}  // namespace wold::grass
