#include "scene/species.h"

#include <gtest/gtest.h>

#include <utility>

#include "grass/texel/blade_patch.h"
#include "grass/texel/rasterise.h"
#include "grass/texel/samples.h"
#include "grass/texel/time_varying_texel.h"
#include "small_meadow.h"
#include "support/temporary_folder.h"

namespace wold::grass {
namespace {

/// The small meadow of two species of as many blades: the scene's, and one of broad, short,
/// evergreen blades.
scene::Scene two_species() {
  scene::Scene scene = test::small_scene();
  scene.species = scene::species_of(scene);
  scene.species.push_back(scene.species[0]);
  scene::Species& broad = scene.species[1];
  broad.plant.width_m *= 2.0;
  broad.plant.height_m *= 0.5;
  broad.plant.mingle = {{"evergreen", {}}};
  return scene;
}

Texel texel_of(const scene::Scene& scene, double weathering) {
  const MeadowModel model(scene);
  Samples samples(scene, test::small_shape(), 0, model);
  samples.advance_to(weathering);
  return samples.texel();
}

TEST(SpeciesPatch, OfOneIsThatOfTheTables) {
  scene::Scene scene = test::small_scene();
  const Texel by_tables = texel_of(scene, 0.4);
  scene.species = scene::species_of(scene);
  const Texel by_list = texel_of(scene, 0.4);
  EXPECT_EQ(by_list.voxel, by_tables.voxel);
  EXPECT_EQ(by_list.density, by_tables.density);
  EXPECT_EQ(by_list.albedo, by_tables.albedo);
}

TEST(SpeciesPatch, HasTheBladesOfBoth) {
  const scene::Scene scene = two_species();
  const MeadowModel model(scene);
  const BladePatch patch = WitheringPatch(scene, model, 0).at(0.0);
  double length_m[2] = {}, radius_m[2] = {};
  int blades[2] = {};
  for (const Blade& blade : patch.blades) {
    length_m[blade.species] += double{blade.length_m};
    radius_m[blade.species] += double{blade.radius_m};
    ++blades[blade.species];
  }
  EXPECT_EQ(blades[0] + blades[1], scene.grass.blades);
  EXPECT_NEAR(blades[0], blades[1], 1);
  EXPECT_NEAR(length_m[1] / blades[1] / (length_m[0] / blades[0]), 0.5, 0.05);
  EXPECT_NEAR(radius_m[1] / blades[1] / (radius_m[0] / blades[0]), 2.0, 0.2);
}

// Algorithm 2: densities add up, so areas do.
TEST(SpeciesPatch, MinglesTheAreaOfBoth) {
  const scene::Scene scene = two_species();
  const MeadowModel model(scene);
  Samples samples(scene, test::small_shape(), 0, model);
  samples.advance_to(0.2);
  double sum_m2 = 0.0;
  for (const PointDynamics& sample : samples.all())
    sum_m2 += rasterise_points(sample.points(), test::small_shape()).area_m2();
  EXPECT_NEAR(samples.texel().area_m2() / sum_m2, 1.0, 1e-3);
}

TEST(SpeciesPatch, EachWithersByItsOwnModel) {
  scene::Scene scene = two_species();
  scene.ageing.onset_spread = 0.0;
  scene.species[1].physiology.brown_pigment = 0.0;
  const MeadowModel model(scene);
  const BladePatch patch = WitheringPatch(scene, model, 0).at(0.7);
  double green[2] = {}, red[2] = {}, age[2] = {};
  for (std::size_t i = 0; i < patch.blades.size(); ++i) {
    const int species = patch.blades[i].species;
    const SeenPlace seen = seen_place(patch, model, i, 0.5, AxisPoint{{0, 0}, {0, 1}});
    green[species] += double{seen.albedo.g};
    red[species] += double{seen.albedo.r};
    age[species] += patch.ages[i];
  }
  EXPECT_LT(age[1], 0.5 * age[0]);                        // evergreen
  EXPECT_GT(green[1] / red[1], 1.2 * green[0] / red[0]);  // and it shows
}

// The patches of the second mixture lack the broad species and have as many blades of the other;
// those of the first are what they are without habitats.
TEST(SpeciesPatch, OfAMixtureHasItsSpeciesAlone) {
  scene::Scene scene = two_species();
  const MeadowModel model(scene);
  const auto blades = [&](int variant) {
    return WitheringPatch(scene, model, variant).at(0.3).blades;
  };
  const std::vector<Blade> of_both = blades(1);
  scene.species[1].habitat.cover = 0.5;
  ASSERT_EQ(scene::patch_count(scene), 2 * scene.grass.variants);
  const std::vector<Blade> still = blades(1);
  ASSERT_EQ(still.size(), of_both.size());
  for (std::size_t i = 0; i < still.size(); ++i) EXPECT_EQ(still[i].root_m, of_both[i].root_m);
  const std::vector<Blade> of_one = blades(scene.grass.variants + 1);
  EXPECT_EQ(static_cast<int>(of_one.size()), scene.grass.blades);
  for (const Blade& blade : of_one) EXPECT_EQ(blade.species, 0);
}

// A habitat changes no patch of all species, so that its files stay; but files of two mixtures that
// have the same number in two scenes are not taken for each other's.
TEST(SpeciesPatch, ContentIsTheMixtures) {
  scene::Scene scene = two_species();
  const wold::test::TemporaryFolder folder("mixtures");
  const auto content = [&](int variant) {
    return TimeVaryingTexel(scene, {Lighting{}}, folder.path()).content(variant, {0, 0});
  };
  const std::string of_both = content(1);
  scene.species[0].habitat.cover = 0.5;
  EXPECT_EQ(content(1), of_both);
  const std::string without_first = content(scene.grass.variants);
  std::swap(scene.species[0].habitat, scene.species[1].habitat);
  EXPECT_NE(content(scene.grass.variants), without_first);
}

}  // namespace
}  // namespace wold::grass
