#include "sky/cloud_layer_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scene/scene.h"

namespace wold::sky {
namespace {

constexpr double deg = std::numbers::pi / 180.0;
constexpr double pixel_m = 20.0;
const glm::dvec3 eye_m(300.0, -200.0, 2.0);

/// Heaps half-way gathered, 1200 m above the eye.
scene::Scene cumulus_layer(double sun_azimuth_deg, double sun_elevation_deg) {
  scene::Scene scene;
  scene.clouds.resize(1);
  scene.clouds[0].base_m = 1200.0 + eye_m.z;
  scene.clouds[0].cells = {4, 4};
  scene.clouds[0].gathered = 0.7;
  scene.sun.azimuth_deg = sun_azimuth_deg;
  scene.sun.elevation_deg = sun_elevation_deg;
  return scene;
}

struct Sight {
  light::Daylight day;
  cloud::LayerState layer;
  CloudLayerView seen;

  explicit Sight(const scene::Scene& scene)
      : day(scene.sun, scene.sky),
        layer(cloud::Clouds(scene, pixel_m).at(10.0).layers[0]),
        seen(layer, pixel_m, eye_m, day, 5e-4, std::nullopt) {}
  Sight(const Sight&) = delete;
  Sight& operator=(const Sight&) = delete;

  /// Vertical optical depth of the layer where the line of sight meets its base.
  double base_depth(const glm::dvec3& direction) const {
    const glm::dvec2 place_m = glm::dvec2(eye_m) + glm::dvec2(direction) * (1200.0 / direction.z);
    return cloud::optical_depth_at(layer, pixel_m, place_m);
  }
};

/// Green that clouds send, of what they hide, over a white card's in the open.
double brightness(const SeenClouds& clouds) {
  return double{clouds.sent.g} / (1.0 - double{clouds.through}) * std::numbers::pi;
}

struct Mean {
  double sum = 0.0;
  int count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return sum / count; }
};

/// Every direction of a part of the sky, some minutes of arc apart.
template <class Body>
void for_directions(double azimuth_deg, double elevation_deg, double reach_deg, const Body& body) {
  for (double a = -reach_deg; a <= reach_deg; a += 0.25)
    for (double e = -reach_deg; e <= reach_deg; e += 0.25)
      body(light::direction_of((azimuth_deg + a) * deg, (elevation_deg + e) * deg));
}

// "Every cloud has a silver lining": edges before the sun outshine what is opaque; away from it
// they do not.
TEST(CloudLayerView, EdgesShineAroundTheSun) {
  const Sight sight(cumulus_layer(180.0, 25.0));
  const auto edges_over_middles = [&](double azimuth_deg) {
    Mean edges, middles;
    for_directions(azimuth_deg, 25.0, 12.0, [&](const glm::dvec3& direction) {
      const SeenClouds clouds = sight.seen.along(direction);
      if (clouds.through > 0.2F && clouds.through < 0.8F) edges.add(brightness(clouds));
      if (clouds.through < 0.02F) middles.add(brightness(clouds));
    });
    EXPECT_GT(edges.count, 50);
    EXPECT_GT(middles.count, 50);
    return edges.value() / middles.value();
  };
  const double around = edges_over_middles(180.0), aside = edges_over_middles(90.0);
  EXPECT_GT(around, 3.0);
  EXPECT_GT(around, 1.5 * aside) << aside;
}

// A sun that has just set for the ground shines on high clouds, red; later they have the light of
// the sky alone.
TEST(CloudLayerView, GlowsAfterSunset) {
  const auto mean_sent = [](double elevation_deg) {
    scene::Scene scene = cumulus_layer(180.0, elevation_deg);
    scene.clouds[0].kind = scene::CloudKind::cirrus;
    scene.clouds[0].base_m = 6000.0;
    scene.clouds[0].gathered = 1.0;
    const Sight sight(scene);
    glm::dvec3 sum(0.0);
    for_directions(180.0, 15.0, 5.0, [&](const glm::dvec3& direction) {
      const SeenClouds clouds = sight.seen.along(direction);
      for (int c = 0; c < 3; ++c) {
        ASSERT_TRUE(std::isfinite(clouds.sent[c]));
        ASSERT_GE(clouds.sent[c], 0.0F);
      }
      sum += glm::dvec3(clouds.sent);
    });
    return sum / glm::dvec3(sight.day.level_irradiance());
  };
  const glm::dvec3 glow = mean_sent(-1.0), later = mean_sent(-4.0);
  EXPECT_GT(glow.r, 2.0 * later.r);
  EXPECT_GT(glow.r / glow.b, 1.5);
  EXPECT_NEAR(later.r / later.b, 1.0, 0.02);
}

// Where it lights a layer from below, the base that is seen sends some of it back.
TEST(CloudLayerView, IsNoDarkerForSunlightFromBelow) {
  const auto base = [](double elevation_deg) {
    scene::Scene scene = cumulus_layer(180.0, elevation_deg);
    scene.clouds[0].kind = scene::CloudKind::stratus;
    scene.clouds[0].base_m = 6000.0;
    scene.clouds[0].gathered = 1.0;
    const Sight sight(scene);
    const glm::vec3 sent = sight.seen.along(light::direction_of(0.0, 60.0 * deg)).sent;
    return sent / sight.day.level_irradiance();
  };
  const glm::vec3 lit = base(-1.5), unlit = base(-4.0);
  EXPECT_GT(lit.r, unlit.r);
  EXPECT_GT(lit.r / lit.b, 1.01F * unlit.r / unlit.b);
}

// At sunset clouds have more light, and redder, on what is turned to the sun than within.
TEST(CloudLayerView, GlowTowardsASunThatSets) {
  const Sight sight(cumulus_layer(0.0, 3.0));
  Mean bright, dark, red_of_bright, red_of_dark;
  std::vector<glm::vec3> seen;
  for_directions(180.0, 22.0, 10.0, [&](const glm::dvec3& direction) {
    const SeenClouds clouds = sight.seen.along(direction);
    if (clouds.through < 0.02F) seen.push_back(clouds.sent);
  });
  ASSERT_GT(seen.size(), 200U);
  std::ranges::sort(seen, {}, &glm::vec3::g);
  for (std::size_t i = 0; i < seen.size() / 5; ++i) {
    const glm::vec3 &darker = seen[i], &brighter = seen[seen.size() - 1 - i];
    dark.add(double{darker.g});
    bright.add(double{brighter.g});
    red_of_dark.add(double{darker.r / darker.b});
    red_of_bright.add(double{brighter.r / brighter.b});
  }
  EXPECT_GT(bright.value(), 2.0 * dark.value());
  EXPECT_GT(red_of_bright.value(), 1.3 * red_of_dark.value());
}

// With the sun in the back, sides send back 0.4 to 0.9 of what falls on a plane that faces the
// sun (Bohren 1987 has 0.7 for an optical depth of 23, and not all face it), and bases are dark.
TEST(CloudLayerView, SidesAreSunlitAboveDarkBases) {
  const Sight sight(cumulus_layer(0.0, 30.0));
  Mean sides, bases;
  for_directions(180.0, 22.0, 10.0, [&](const glm::dvec3& direction) {
    const SeenClouds clouds = sight.seen.along(direction);
    const double base = sight.base_depth(direction);
    if (clouds.through > 0.02F) return;
    if (base > 2.0) bases.add(brightness(clouds));
    if (base <= 0.0) sides.add(brightness(clouds));
  });
  EXPECT_GT(bases.count, 100);
  EXPECT_GT(sides.count, 100);
  const double on_facing =
      double{sight.day.sun_irradiance().g} + double{sight.day.sky_irradiance().g};
  EXPECT_GT(sides.value(), 0.4 * on_facing);
  EXPECT_LT(sides.value(), 0.9 * on_facing);
  EXPECT_GT(sides.value(), 1.5 * bases.value());
}

// Where the base is open, clouds are seen all the same if they are heaps.
TEST(CloudLayerView, OnlyDenseLayersHaveSides) {
  scene::Scene scene = cumulus_layer(180.0, 30.0);
  const auto seen_beside_bases = [&] {
    const Sight sight(scene);
    int count = 0;
    for_directions(0.0, 30.0, 15.0, [&](const glm::dvec3& direction) {
      count += sight.base_depth(direction) <= 0.0 && sight.seen.along(direction).through < 0.1F;
    });
    return count;
  };
  EXPECT_GT(seen_beside_bases(), 500);
  scene.clouds[0].thickness_m = 40.0;
  EXPECT_LT(seen_beside_bases(), 50);  // what is finer than the map
  scene.clouds[0].thickness_m = 500.0;
  scene.clouds[0].light = scene::Law::paper;
  EXPECT_LT(seen_beside_bases(), 50);
}

}  // namespace
}  // namespace wold::sky
