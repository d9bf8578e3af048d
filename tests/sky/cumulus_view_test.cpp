#include "sky/cumulus_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "scene/scene.h"

namespace wold::sky {
namespace {

constexpr double deg = std::numbers::pi / 180.0;
constexpr double base_m = 1200.0;
constexpr double finest_rad = 5e-4;

/// Cumulus over an eye on the ground.
struct Heap {
  scene::Scene scene;
  light::Daylight day{scene.sun, scene.sky};
  cloud::LayerState layer;
  std::vector<cloud::Sheet> sheets;
  cloud::Heaps heaps;
  CumulusView view;

  Heap()
      : layer([&] {
          scene.clouds.resize(1);
          scene.clouds[0].base_m = base_m;
          scene.clouds[0].cells = {4, 4};
          return cloud::Clouds(scene, 20.0).at(0.0).layers[0];
        }()),
        sheets(cloud::sheets_of(layer, 20.0)),
        heaps(layer, sheets),
        view(layer, sheets, glm::dvec3(0.0), day, finest_rad, std::nullopt) {}
  Heap(const Heap&) = delete;
  Heap& operator=(const Heap&) = delete;

  /// What comes through, in steps of metres; the law of extinction of CumulusView.
  double through(const glm::dvec3& direction) const {
    constexpr double step_m = 2.0;
    const double first_m = base_m / direction.z;
    const double last_m = (base_m + heaps.highest_m()) / direction.z;
    double depth = 0.0;
    for (double at_m = first_m; at_m < last_m && depth < 8.0; at_m += step_m) {
      const double inside =
          std::clamp(heaps.field(at_m * direction, finest_rad * first_m) / 0.5, 0.0, 1.0);
      depth += step_m * layer.layer->droplets.extinction_per_m * inside * inside;
    }
    return std::exp(-depth);
  }
};

// Where a head stands before the sky it is found.
TEST(CumulusView, FindsTheHeadsThatTheEyeMakesOut) {
  const Heap heap;
  int seen = 0, missed = 0, edges = 0;
  for (std::uint64_t i = 0; i < 6000; ++i) {
    const glm::dvec3 direction =
        light::direction_of(2.0 * std::numbers::pi * random_uniform({i, 0}),
                            (25.0 + 55.0 * random_uniform({i, 1})) * deg);
    const double wanted = heap.through(direction);
    const double got = double{heap.view.along(direction).through};
    seen += wanted < 0.9;
    edges += wanted > 0.1 && wanted < 0.9;
    missed += std::abs(got - wanted) > 0.1;
  }
  EXPECT_GT(seen, 1000);
  EXPECT_GT(edges, 200);
  EXPECT_LE(missed, 10);
}

}  // namespace
}  // namespace wold::sky
