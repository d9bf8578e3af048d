#include "meadow/pigment_spread.h"

#include <gtest/gtest.h>

#include <cmath>

#include "grass/mechanics/dynamics.h"
#include "grass/optics/leaf_colour.h"

namespace wold::meadow {
namespace {

/// A meadow whose blades are all of the same age: fresh, or dead to the tip.
scene::Scene even_meadow() {
  scene::Scene scene;
  scene.grass.blades = 20;
  scene.ageing.fresh_spread = 0.0;
  scene.ageing.litter = 0.0;
  scene.grass.specular = 0.0;
  return scene;
}

/// Seen across the sun's rays, where blades show what they reflect and what they let through alike.
grass::Lighting half_the_sky() {
  return {.sun_direction = {0.0, 0.6, 0.8},
          .sun_irradiance = glm::vec3(3.0F),
          .sky_radiance = std::vector<glm::vec3>(grass::sky_size(), glm::vec3(0.2F)),
          .eye_direction = {1.0, 0.0, 0.0}};
}

struct Pasture {
  explicit Pasture(const scene::Scene& scene)
      : model(scene),
        patch(scene, model, /*variant=*/0),
        pigment_spread(scene, patch, /*snow=*/0.0, half_the_sky()) {}

  grass::MeadowModel model;
  grass::WitheringPatch patch;
  PigmentSpread pigment_spread;
};

TEST(PigmentSpread, HasTheDeviationThatWasAskedForAndNoneThatAMapCannotShow) {
  const Pasture pasture(even_meadow());
  double sum = 0.0, squares = 0.0;
  int places = 0;
  for (double x = 0.5; x < 512.0; x += 3.7)
    for (double y = 0.5; y < 512.0; y += 3.7, ++places) {
      const double richness = pasture.pigment_spread.richness({x, y}, 0.01);
      sum += richness;
      squares += richness * richness;
      EXPECT_EQ(pasture.pigment_spread.richness({x, y}, 10.0), 0.0);
    }
  EXPECT_NEAR(sum / places, 0.0, 0.05);
  EXPECT_NEAR(std::sqrt(squares / places), 1.0, 0.05);
}

/// What a canopy of such leaves scatters, by the recollision probability 0.45.
glm::vec3 canopy(const scene::Ageing& ageing, double weathering) {
  const glm::vec3 leaf = grass::LeafColour(ageing)(weathering).albedo;
  return leaf / (1.0F - 0.45F * leaf);
}

// The leaf model knows what more chlorophyll and less brown pigment look like.
TEST(PigmentSpread, IsThatOfTheLeavesPigments) {
  scene::Scene scene = even_meadow();
  scene.ageing.chlorophyll_ug_cm2 = 31.5;
  scene.ageing.carotenoid_ug_cm2 = 3.5;
  scene.ageing.brown_pigment = 0.6;
  scene::Ageing rich = scene.ageing;
  rich.chlorophyll_ug_cm2 *= std::exp(2.5 * rich.pigment_spread);
  rich.brown_pigment *= std::exp(-2.5 * rich.pigment_spread);
  const Pasture pasture(scene);
  for (const double weathering : {0.0, 1.0}) {
    const glm::vec3 wanted = canopy(rich, weathering) / canopy(scene.ageing, weathering);
    const glm::vec3 got = pasture.pigment_spread.factor(2.5, weathering);
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(got[channel], wanted[channel], 0.02) << weathering;
    EXPECT_EQ(pasture.pigment_spread.factor(0.0, weathering), glm::vec3(1.0F));
  }
  EXPECT_LT(pasture.pigment_spread.factor(2.0, 0.0).r, 0.9);
  EXPECT_GT(pasture.pigment_spread.factor(2.0, 1.0).b, 1.1);
}

TEST(PigmentSpread, HairHasNone) {
  scene::Scene scene = even_meadow();
  scene.ageing.colour = scene::ColourModel::melanin;
  EXPECT_EQ(Pasture(scene).pigment_spread.factor(2.5, 0.5), glm::vec3(1.0F));
}

}  // namespace
}  // namespace wold::meadow
