#include <gtest/gtest.h>

#include "grass/geometry/axis.h"
#include "grass/geometry/clumps.h"
#include "grass/optics/coat.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

scene::Scene small_fur() {
  scene::Scene scene = test::small_scene();
  scene.grass.blades = 900;
  scene.grass.height_m = 0.06;
  scene.grass.bend = 0.5;
  scene.ageing.water = {"", {{0.0, 1.0}, {0.5, 0.2}, {1.0, 0.02}}};
  scene.ageing.colour = scene::ColourModel::melanin;
  scene.ageing.vein_shrinkage = 0.0;
  scene.ageing.mesophyll_shrinkage = 0.01;
  scene.ageing.fur.clumps = 40;
  return scene;
}

/// Where the tips of a hair are, on the tiling patch.
glm::vec3 tip(const AgeingModel& model, const Blade& hair, double weathering) {
  const BladeAxis axis(hair, model.pose(hair, weathering));
  return on_patch_m(hair, axis.at(hair.length_m));
}

/// Mean distance from a tip to the nearest other one, level, over the borders of the patch.
double tip_spacing_m(const std::vector<glm::vec3>& tips, float patch_m) {
  double sum = 0.0;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    float nearest = patch_m;
    for (std::size_t j = 0; j < tips.size(); ++j) {
      glm::vec2 way(tips[j] - tips[i]);
      way -= patch_m * glm::round(way / patch_m);
      if (i != j) nearest = std::min(nearest, glm::length(way));
    }
    sum += double{nearest};
  }
  return sum / static_cast<double>(tips.size());
}

struct Coat {
  explicit Coat(double weathering) {
    const scene::Scene scene = small_fur();
    const AgeingModel model(scene.ageing, 0.1);
    for (const Blade& hair : scatter_blades(scene.grass, scene.ageing,
                                            {scene.grass.patch_m, scene.grass.blades, 7, 0})) {
      tips.push_back(tip(model, hair, weathering));
      height_m += double{tips.back().z} / scene.grass.blades;
      combed_m += double{glm::dot(glm::vec2(tips.back()) - hair.root_m, glm::vec2(1.0F, 0.0F))} /
                  scene.grass.blades;
    }
    spacing_m = tip_spacing_m(tips, static_cast<float>(scene.grass.patch_m));
  }
  std::vector<glm::vec3> tips;
  double height_m = 0.0;
  double combed_m = 0.0;  ///< to the east
  double spacing_m = 0.0;
};

// 900 tips at random places of the patch are 0.5 / sqrt(n / A) = 4.2 mm apart on average (Clark and
// Evans 1954); wet ones meet in their clumps' tips, dry ones are as far apart as random ones.
TEST(Fur, LiesInClumpsWhenWetAndFluffsUpWhenDry) {
  const Coat wet(0.0);
  const Coat dry(1.0);
  const double random_m = 0.5 * small_fur().grass.patch_m / 30.0;
  EXPECT_LT(wet.spacing_m, 0.3 * random_m);  // short hairs do not get there
  EXPECT_GT(dry.spacing_m, 0.8 * random_m);
  EXPECT_GT(dry.height_m, 1.3 * wet.height_m);
  EXPECT_NEAR(wet.combed_m, small_fur().ageing.fur.lying * 0.06, 0.004);
}

// Water of index 1.33 makes a surface of albedo 0.5 one of 0.39 and leaves white and black as they
// are (Lekner and Dorf 1988, but for the 6.6 % of a mirror's light that white loses).
TEST(Fur, DarkensUnderWater) {
  LeafSpectra spectra;
  scene::Fur fur;
  fur.eumelanin_um = 1.0;
  fur.pheomelanin_um = 0.0;
  const auto albedo = [&](double absorption_mm, double wet) {
    spectra.eumelanin_mm = {absorption_mm};
    spectra.pheomelanin_mm = {0.0};
    const LeafSpectrum hair = hair_spectrum(fur, spectra, wet);
    return hair.reflectance.front() + hair.transmittance.front();
  };
  const double half = -1000.0 * std::log(1.0 - 0.5 / 0.95);
  EXPECT_NEAR(albedo(half, 0.0), 0.5, 1e-12);
  EXPECT_NEAR(albedo(half, 1.0), 0.389, 0.001);
  EXPECT_NEAR(albedo(half, 0.25), 0.75 * 0.5 + 0.25 * albedo(half, 1.0), 1e-12);
  EXPECT_DOUBLE_EQ(albedo(0.0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(albedo(0.0, 1.0), 1.0);
}

// Melanin takes blue before red: a fox is red, and less so with black pigment.
TEST(Fur, IsRedByPheomelanin) {
  scene::Scene scene = small_fur();
  const auto dry = [&] { return LeafColour(scene.ageing)(1.0).albedo; };
  const glm::vec3 fox = dry();
  EXPECT_GT(fox.r, 1.5F * fox.g);
  EXPECT_GT(fox.g, 1.5F * fox.b);
  scene.ageing.fur.eumelanin_um = 60.0;
  const glm::vec3 black = dry();
  EXPECT_LT(black.r, 0.2F);
}

}  // namespace
}  // namespace wold::grass
