#include "place/viewpoint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "terrain/relief.h"

namespace wold::place {
namespace {

constexpr double size_m = 12000.0;

ViewSearch search() { return {1.7, 55.0, 0.5625, glm::normalize(glm::dvec3(-1.0, 0.0, 0.8))}; }

/// Land of low hills.
double hills_m(const glm::dvec2& at_m) {
  return 30.0 * std::sin(at_m.x / 700.0) * std::cos(at_m.y / 900.0);
}

template <class Height>
Heightfield land(const Height& height_m) {
  Heightfield map(257, size_m);
  for (int j = 0; j < map.samples(); ++j)
    for (int i = 0; i < map.samples(); ++i)
      map.at(i, j) = static_cast<float>(height_m(map.place_m(i, j)));
  return map;
}

bool is_inside(const glm::dvec2& at_m) {
  return at_m.x >= 0.0 && at_m.y >= 0.0 && at_m.x <= size_m && at_m.y <= size_m;
}

TEST(Viewpoint, LooksAtTheOnlyMountain) {
  const glm::dvec2 summit_m(8000.0, 7500.0);
  const Heightfield terrain = land([&](const glm::dvec2& at_m) {
    const double distance_m = glm::length(at_m - summit_m);
    return hills_m(at_m) + 1200.0 * std::exp(-distance_m * distance_m / (2.0 * 1200.0 * 1200.0));
  });
  const Viewpoint view = find_viewpoint(terrain, search());
  EXPECT_TRUE(is_inside(view.eye_m));
  EXPECT_TRUE(is_inside(view.target_m));
  const glm::dvec2 to_summit = glm::normalize(summit_m - view.eye_m);
  const glm::dvec2 ahead = glm::normalize(view.target_m - view.eye_m);
  constexpr double half_the_picture = 0.887;  // cosine of 27.5 degrees
  EXPECT_GT(glm::dot(to_summit, ahead), half_the_picture);
  EXPECT_GT(glm::length(summit_m - view.eye_m), 1500.0);
}

TEST(Viewpoint, StandsOnGentleGround) {
  const Heightfield terrain = land([](const glm::dvec2& at_m) {
    return 900.0 * std::abs(std::sin(at_m.x / 900.0) * std::sin(at_m.y / 1300.0));
  });
  const Viewpoint view = find_viewpoint(terrain, search());
  EXPECT_LT(terrain::slope_deg(terrain, view.eye_m.x, view.eye_m.y), 20.0);
}

TEST(Viewpoint, IsThereOnAPlainToo) {
  const Viewpoint view = find_viewpoint(land([](const glm::dvec2&) { return 0.0; }), search());
  EXPECT_TRUE(is_inside(view.eye_m));
  EXPECT_TRUE(is_inside(view.target_m));
  EXPECT_NE(view.eye_m, view.target_m);
  EXPECT_GE(view.target_height_m, 0.0);
}

/// Of the same land in the evening as in the morning: the sun is beside the camera, not before it.
TEST(Viewpoint, HasTheSunAside) {
  const Heightfield terrain = land([](const glm::dvec2& at_m) {
    return 300.0 * (std::sin(at_m.x / 800.0) + std::sin(at_m.y / 800.0));
  });
  for (const glm::dvec2& sun : {glm::dvec2(1.0, 0.0), glm::dvec2(0.0, -1.0)}) {
    ViewSearch with_sun = search();
    with_sun.to_sun = glm::normalize(glm::dvec3(sun, 0.5));
    const Viewpoint view = find_viewpoint(terrain, with_sun);
    EXPECT_LT(std::abs(glm::dot(glm::normalize(view.target_m - view.eye_m), sun)), 0.6);
  }
}

}  // namespace
}  // namespace wold::place
