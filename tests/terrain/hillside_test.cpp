#include "terrain/hillside.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "terrain/relief.h"

namespace wold::terrain {
namespace {

// z = x y / 100 m rises by y / 100 to the east and by x / 100 to the north.
TEST(Relief, GradientOfASaddleIsThatOfThePlace) {
  Heightfield saddle(41, 40.0);
  for (int j = 0; j < 41; ++j)
    for (int i = 0; i < 41; ++i) saddle.at(i, j) = 0.01F * static_cast<float>(i * j);
  for (const glm::dvec2 at_m : {glm::dvec2(10.0, 30.0), glm::dvec2(32.0, 5.0)}) {
    const glm::dvec2 rise = gradient(saddle, at_m.x, at_m.y);
    EXPECT_NEAR(rise.x, 0.01 * at_m.y, 1e-5);
    EXPECT_NEAR(rise.y, 0.01 * at_m.x, 1e-5);
  }
}

// Cells are two triangles that meet between south-west and north-east: with that corner alone
// raised, they are as high as the lesser of both coordinates.
TEST(Relief, MeshIsOfTheTrianglesThatAreDrawn) {
  Heightfield cell(2, 1.0);
  cell.at(1, 1) = 1.0F;
  const Heightfield mesh = mesh_heights(cell, {{.size_m = 1.0}, 5});
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(mesh.at(i, j), 0.25 * std::min(i, j), 1e-6);
}

TEST(Relief, PlaneOfSlopeOneRisesEastwards) {
  Heightfield plane(41, 10.0);
  for (int j = 0; j < 41; ++j)
    for (int i = 0; i < 41; ++i) plane.at(i, j) = static_cast<float>(i * plane.step_m());
  for (const glm::dvec2 at_m : {glm::dvec2(5.0, 5.0), glm::dvec2(0.0, 10.0)}) {
    EXPECT_NEAR(slope_deg(plane, at_m.x, at_m.y), 45.0, 1e-5);
    EXPECT_NEAR(aspect_deg(plane, at_m.x, at_m.y), 270.0, 1e-5);
    EXPECT_NEAR(normal(plane, at_m.x, at_m.y).x, -std::numbers::sqrt2 / 2.0, 1e-6);
  }
}

/// Whether a straight line between two points stays above the ground.
bool sees(const Heightfield& terrain, const glm::dvec3& from_m, const glm::dvec3& to_m) {
  for (int k = 1; k < 400; ++k) {
    const glm::dvec3 at_m = glm::mix(from_m, to_m, k / 400.0);
    if (at_m.z < terrain.sample(at_m.x, at_m.y)) return false;
  }
  return true;
}

TEST(Hillside, HidesItsFarEdgesBehindTheCrest) {
  const scene::Scene scene;
  scene::Terrain shape = scene.terrain;
  shape.samples = 161;  // quicker
  const double side_m = scene.terrain.size_m;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Heightfield terrain = make_hillside(shape, seed);
    const auto& [x_m, y_m] = scene.camera.eye_m;
    const glm::dvec3 eye_m(x_m, y_m, terrain.sample(x_m, y_m) + scene.camera.eye_height_m);
    int crest_seen = 0;
    for (double x = 2.0; x <= side_m - 2.0; x += 1.0) {
      EXPECT_FALSE(sees(terrain, eye_m, {x, side_m, terrain.sample(x, side_m)})) << "x = " << x;
      for (double y = 0.5 * side_m; y < 0.8 * side_m && x > 12.0 && x < 28.0; y += 0.5)
        if (sees(terrain, eye_m, {x, y, terrain.sample(x, y) + 0.3})) {
          ++crest_seen;
          break;
        }
    }
    EXPECT_GE(crest_seen, 12);  // of 15 columns in front of the camera
  }
}

TEST(Hillside, FitsCellsOfGrass) {
  const scene::Terrain shape;
  const Heightfield terrain = make_hillside(shape, 1);
  double squares = 0.0;
  int cells = 0;
  for (double y = 0.0; y < shape.size_m; y += 0.5)
    for (double x = 0.0; x < shape.size_m; x += 0.5, ++cells) {
      const double twist = (terrain.sample(x, y) - terrain.sample(x + 0.5, y) -
                            terrain.sample(x, y + 0.5) + terrain.sample(x + 0.5, y + 0.5)) /
                           4.0;
      squares += twist * twist;
      EXPECT_LT(slope_deg(terrain, x, y), shape.talus_deg * 1.15);
    }
  EXPECT_LT(std::sqrt(squares / cells), 0.01);
}

}  // namespace
}  // namespace wold::terrain
