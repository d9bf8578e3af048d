#include "passes/ground_cast.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"

namespace wold::passes {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

template <class Height>
Heightfield terrain_of(int samples, double size_m, const Height& height_m) {
  Heightfield terrain(samples, size_m);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const glm::dvec2 at_m = terrain.place_m(i, j);
      terrain.at(i, j) = static_cast<float>(height_m(at_m.x, at_m.y));
    }
  return terrain;
}

/// Rugged: heights have nothing to do with their neighbours'.
Heightfield rugged(int samples, double size_m) {
  return terrain_of(samples, size_m, [](double x, double y) {
    return 2.0 * random_uniform({3, key_of("height"), static_cast<std::uint64_t>(1e3 * x),
                                 static_cast<std::uint64_t>(1e3 * y)});
  });
}

/// Where a ray meets a triangle, by Moeller and Trumbore (1997); infinite beside it.
double triangle_m(const glm::dvec3& eye_m, const glm::dvec3& direction, const glm::dvec3& a,
                  const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 across = glm::cross(direction, c - a);
  const double volume = glm::dot(b - a, across);
  if (std::abs(volume) < 1e-15) return infinite;
  const double u = glm::dot(eye_m - a, across) / volume;
  const glm::dvec3 turned = glm::cross(eye_m - a, b - a);
  const double v = glm::dot(direction, turned) / volume;
  const double at_m = glm::dot(c - a, turned) / volume;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && at_m > 0.0 ? at_m : infinite;
}

/// The nearest of all triangles: no tree, no steps.
double every_triangle_m(const Heightfield& terrain, const glm::dvec3& eye_m,
                        const glm::dvec3& direction) {
  const auto corner = [&](int i, int j) {
    return glm::dvec3(terrain.place_m(i, j), double{terrain.at(i, j)});
  };
  double nearest_m = infinite;
  for (int j = 0; j + 1 < terrain.samples(); ++j)
    for (int i = 0; i + 1 < terrain.samples(); ++i)
      for (const glm::ivec2 third : {glm::ivec2(1, 0), glm::ivec2(0, 1)})
        nearest_m =
            std::min(nearest_m, triangle_m(eye_m, direction, corner(i, j), corner(i + 1, j + 1),
                                           corner(i + third.x, j + third.y)));
  return nearest_m;
}

glm::dvec3 random_direction(std::uint64_t number) {
  const auto random = [&](const char* purpose) {
    return 2.0 * random_uniform({5, key_of("ray"), number, key_of(purpose)}) - 1.0;
  };
  return glm::normalize(glm::dvec3(random("x"), random("y"), 0.6 * random("z") - 0.3));
}

TEST(GroundCast, MeetsAPlaneWhereItIs) {
  const Heightfield terrain =
      terrain_of(33, 16.0, [](double x, double y) { return 1.0 + 0.25 * x - 0.5 * y; });
  const GroundCast cast(terrain);
  const glm::dvec3 eye_m(5.3, 2.1, 9.0);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.25, 0.5, 1.0));
  for (const glm::dvec3& to_m :
       {glm::dvec3(1.0, 9.0, -3.25), {12.0, 3.0, 2.5}, {5.3, 2.1, 1.275}, {8.0, 8.0, -1.0}}) {
    const glm::dvec3 direction = glm::normalize(to_m - eye_m);
    EXPECT_NEAR(cast.distance_m(eye_m, direction), glm::distance(to_m, eye_m), 1e-6);
    EXPECT_LT(glm::distance(cast.normal(glm::dvec2(to_m)), normal), 1e-6);
  }
}

TEST(GroundCast, SeesAHillThatIsPartOfASphere) {
  constexpr double radius_m = 20.0;
  const glm::dvec3 middle_m(10.0, 10.0, -15.0);
  const auto height_m = [&](double x, double y) {
    const double square_m2 =
        (x - middle_m.x) * (x - middle_m.x) + (y - middle_m.y) * (y - middle_m.y);
    return middle_m.z + std::sqrt(radius_m * radius_m - square_m2);
  };
  const Heightfield terrain = terrain_of(401, 20.0, height_m);
  const GroundCast cast(terrain);
  const glm::dvec3 eye_m(10.0, 0.5, 7.0);
  for (int k = 0; k < 200; ++k) {
    const glm::dvec3 to_m(4.0 + 0.06 * k, 4.0 + 0.03 * k, 0.0);
    const glm::dvec3 at_m(to_m.x, to_m.y, height_m(to_m.x, to_m.y));
    const glm::dvec3 direction = glm::normalize(at_m - eye_m);
    const double outwards = glm::dot(direction, at_m - middle_m) / radius_m;
    if (outwards > -0.05) continue;  // it is the rim or the far side
    // A chord of 7 cm leaves the sphere by 0.03 mm; rays see it at a slant.
    const double distance_m = glm::distance(at_m, eye_m);
    EXPECT_NEAR(cast.distance_m(eye_m, direction), distance_m, 4e-5 / -outwards);
    EXPECT_LT(glm::distance(cast.normal(glm::dvec2(at_m)), (at_m - middle_m) / radius_m), 0.003);
  }
}

TEST(GroundCast, MeetsWhatIsNearestOfAllTriangles) {
  for (const int samples : {2, 3, 8, 24}) {
    const Heightfield terrain = rugged(samples, 10.0);
    const GroundCast cast(terrain);
    int met = 0;
    for (std::uint64_t k = 0; k < 3000; ++k) {
      const glm::dvec3 eye_m(10.0 * random_uniform({7, key_of("eye"), k, 0}),
                             10.0 * random_uniform({7, key_of("eye"), k, 1}),
                             2.5 + 2.0 * random_uniform({7, key_of("eye"), k, 2}));
      const glm::dvec3 direction = random_direction(k);
      const double want_m = every_triangle_m(terrain, eye_m, direction);
      const double got_m = cast.distance_m(eye_m, direction);
      ASSERT_EQ(std::isfinite(got_m), std::isfinite(want_m)) << samples << " " << k;
      if (!std::isfinite(want_m)) continue;
      ++met;
      ASSERT_NEAR(got_m, want_m, 1e-6 * (1.0 + want_m)) << samples << " " << k;
    }
    EXPECT_GT(met, 500);
  }
}

TEST(GroundCast, MissesNothingAlongTheLinesOfItsGrid) {
  const Heightfield terrain = rugged(17, 16.0);
  const GroundCast cast(terrain);
  const glm::dvec3 eye_m(8.0, 8.0, 30.0);
  for (int j = 0; j < 17; ++j)
    for (int i = 0; i < 17; ++i) {
      const glm::dvec3 at_m(i, j, terrain.at(i, j));
      const glm::dvec3 direction = glm::normalize(at_m - eye_m);
      const double distance_m = cast.distance_m(eye_m, direction);
      const bool is_outermost = i % 16 == 0 || j % 16 == 0;
      if (is_outermost && !std::isfinite(distance_m)) continue;  // it passes by for the last bit
      EXPECT_LE(distance_m, glm::distance(at_m, eye_m) + 1e-9) << i << " " << j;
    }
}

TEST(GroundCast, SeesGroundFromBelow) {
  const Heightfield terrain = terrain_of(9, 8.0, [](double, double) { return 3.0; });
  const GroundCast cast(terrain);
  EXPECT_NEAR(cast.distance_m({4.2, 4.1, 1.0}, {0.0, 0.0, 1.0}), 2.0, 1e-12);
  EXPECT_EQ(cast.distance_m({4.2, 4.1, 1.0}, {0.0, 0.0, -1.0}), infinite);
  EXPECT_EQ(cast.distance_m({-4.2, 4.1, 5.0}, {-1.0, 0.0, 0.0}), infinite);
}

}  // namespace
}  // namespace wold::passes
