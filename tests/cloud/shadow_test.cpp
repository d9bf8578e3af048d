#include "cloud/shadow.h"

#include <gtest/gtest.h>

#include "core/image.h"
#include "light/daylight.h"
#include "support/temporary_folder.h"

namespace wold::cloud {
namespace {

scene::Scene one_layer() {
  scene::Scene scene;
  scene.clouds.resize(1);
  scene.clouds[0].cell_m = 400.0;
  scene.clouds[0].cells = {2, 2};
  scene.clouds[0].base_m = 1000.0;
  return scene;
}

TEST(Shadow, OfAVeilIsBeersLawAlongTheRay) {
  const test::TemporaryFolder folder("shadow");
  Image veil(1, 1, 1);
  veil.values[0] = 0.5F;
  write_image(folder.path() / "veil.exr", veil, PixelFormat::float32);
  scene::Scene scene = one_layer();
  scene.clouds[0].textures = {(folder.path() / "veil.exr").string()};
  const CloudState state = Clouds(scene, 10.0).at(0.0);
  const glm::dvec3 sun = light::direction_of(1.0, 0.5);
  const FactorMap fraction = sunlit_fraction(state, Heightfield(9, 42.0), sun, 5);
  for (const float value : fraction.values()) EXPECT_NEAR(value, std::pow(0.5, 1.0 / sun.z), 1e-3);
}

// A ray along the ground leaves a round earth: it meets what is 1000 m above at the sine sqrt(2 h /
// R). A sun that has set shines as from the horizon.
TEST(Shadow, OfASunOnTheHorizonEnds) {
  const test::TemporaryFolder folder("shadow");
  Image veil(1, 1, 1);
  veil.values[0] = 0.01F;
  write_image(folder.path() / "veil.exr", veil, PixelFormat::float32);
  scene::Scene scene = one_layer();
  scene.clouds[0].textures = {(folder.path() / "veil.exr").string()};
  const CloudState state = Clouds(scene, 10.0).at(0.0);
  const double sine = std::sqrt(2.0 * 1000.0 / 6.371e6);
  for (const double elevation_rad : {0.0, -0.004, -0.07}) {
    const glm::dvec3 sun = light::direction_of(1.0, elevation_rad);
    const FactorMap fraction = sunlit_fraction(state, Heightfield(9, 42.0), sun, 5);
    for (const float value : fraction.values())
      EXPECT_NEAR(value, std::pow(0.99, 1.0 / sine), 2e-3);
  }
}

TEST(Shadow, LiesAwayFromTheSunByHeightOverTangent) {
  const CloudState state = Clouds(one_layer(), 10.0).at(0.0);
  const Heightfield plain(9, 200.0, 100.0F);
  const glm::dvec3 overhead(0.0, 0.0, 1.0);
  const glm::dvec3 south_east = glm::normalize(glm::dvec3(0.4, -0.2, 0.9));
  const FactorMap fraction = sunlit_fraction(state, plain, south_east, 21);
  // The same clouds overhead, as far north-west as 900 m of height take the shadow.
  CloudState moved = state;
  moved.layers[0].moment.way_m = glm::dvec2(-0.4, 0.2) * 1000.0;
  const FactorMap under = sunlit_fraction(moved, plain, overhead, 21);
  double min = 1.0;
  for (std::size_t i = 0; i < fraction.values().size(); ++i) {
    // The earth's curve moves the shadow by some centimetres.
    EXPECT_NEAR(fraction.values()[i], std::pow(under.values()[i], 1.0 / south_east.z), 4e-3);
    min = std::min(min, static_cast<double>(fraction.values()[i]));
  }
  EXPECT_LT(min, 0.9);
}

TEST(Shadow, PlacesAboveTheLayerHaveNone) {
  const CloudState state = Clouds(one_layer(), 10.0).at(0.0);
  const FactorMap fraction =
      sunlit_fraction(state, Heightfield(9, 200.0, 2000.0F), {0.0, 0.0, 1.0}, 9);
  for (const float value : fraction.values()) EXPECT_EQ(value, 1.0F);
}

}  // namespace
}  // namespace wold::cloud
