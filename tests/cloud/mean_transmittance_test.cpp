#include <gtest/gtest.h>

#include <cmath>

#include "cloud/clouds.h"

namespace wold::cloud {
namespace {

/// The mean over many places, all over the layers' period.
double sampled(const CloudState& state, double pixel_m, double sine) {
  constexpr int side = 400;
  const glm::dvec2 period_m = state.layers[0].layer->period_m;
  double sum = 0.0;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const glm::dvec2 place_m = glm::dvec2(i + 0.5, j + 0.5) / double{side} * period_m;
      sum += std::exp(-optical_depth_at(state.layers[0], pixel_m, place_m) / sine);
    }
  return sum / (side * side);
}

TEST(MeanTransmittance, IsThatOfPlacesAllOverTheLayer) {
  for (const auto kind :
       {scene::CloudKind::cumulus, scene::CloudKind::stratus, scene::CloudKind::cirrus})
    for (const double gathered : {0.5, 1.0}) {
      scene::Scene scene;
      scene.clouds.resize(1);
      scene.clouds[0].kind = kind;
      scene.clouds[0].gathered = gathered;
      const double pixel_m = Clouds::usual_pixel_m(scene.clouds);
      const CloudState state = Clouds(scene, pixel_m).at(0.0);
      EXPECT_NEAR(mean_transmittance(state, 0.5), sampled(state, pixel_m, 0.5), 0.03)
          << static_cast<int>(kind) << ' ' << gathered;
    }
}

TEST(MeanTransmittance, OfLayersAboveEachOtherIsTheProduct) {
  scene::Scene scene;
  EXPECT_EQ(mean_transmittance(CloudState{}, 0.5), 1.0);
  scene.clouds.resize(1);
  const double one = mean_transmittance(Clouds(scene, 40.0).at(0.0), 0.5);
  scene.clouds.resize(2);
  EXPECT_NEAR(mean_transmittance(Clouds(scene, 40.0).at(0.0), 0.5), one * one, 1e-12);
}

}  // namespace
}  // namespace wold::cloud
