#include "passes/standing_blades.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "passes/paint.h"
#include "support/constant_meadow.h"
#include "support/plain_facts.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"

namespace wold::passes {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double random_number(const char* purpose, std::uint64_t number) {
  return random_uniform({11, key_of(purpose), number});
}

/// Blades of three corners that go anywhere.
std::shared_ptr<const Tubes> thicket(int blades) {
  auto tubes = std::make_shared<Tubes>();
  tubes->rings = 4;
  tubes->corners = 3;
  for (int k = 0; k < 12 * blades; ++k) {
    const auto number = static_cast<std::uint64_t>(k);
    const auto blade = static_cast<std::uint64_t>(k / 12);
    tubes->vertices_m.emplace_back(
        0.5 * random_number("x", blade) + 0.05 * random_number("dx", number),
        0.5 * random_number("y", blade) + 0.05 * random_number("dy", number),
        0.1 * (k / 3 % 4) + 0.02 * random_number("dz", number));
  }
  tubes->radiance.resize(static_cast<std::size_t>(4 * blades));
  return tubes;
}

landscape::Landscape thickets() {
  landscape::Landscape landscape;
  for (const int blades : {1, 3, 40})
    landscape.blade_meshes.push_back({"thicket", thicket(blades)});
  for (int k = 0; k < 9; ++k) {
    glm::dmat4 world_from_cell(1.0);
    world_from_cell[0].z = 0.1 * k;         // lies on a slope
    world_from_cell[2].x = 0.3 - 0.05 * k;  // and leans
    world_from_cell[3] = {0.5 * (k % 3), 0.5 * (k / 3), 0.02 * k, 1.0};
    landscape.blade_cells.push_back({world_from_cell, k % 3});
  }
  return landscape;
}

/// Where the ray meets the plane of a triangle, if it is inside all of its sides.
double meeting_m(const glm::dvec3& eye_m, const glm::dvec3& along, const glm::dvec3& a,
                 const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double at_m = glm::dot(a - eye_m, normal) / glm::dot(along, normal);
  const glm::dvec3 place = eye_m + at_m * along;
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
    if (glm::dot(glm::cross(to - from, place - from), normal) < 0.0) return infinite;
  return at_m > 0.0 ? at_m : infinite;
}

/// The nearest of all faces of all cells in world space: no trees.
double every_face_m(const landscape::Landscape& landscape, const glm::dvec3& eye_m,
                    const glm::dvec3& along) {
  double nearest_m = infinite;
  for (const landscape::BladeCell& cell : landscape.blade_cells) {
    const Tubes& tubes = *landscape.blade_meshes[static_cast<std::size_t>(cell.mesh)].tubes;
    const std::vector<std::uint32_t> quads = quad_corners(tubes);
    const auto corner = [&](std::size_t i) {
      return glm::dvec3(cell.world_from_cell *
                        glm::dvec4(glm::dvec3(tubes.vertices_m[quads[i]]), 1.0));
    };
    for (std::size_t i = 0; i < quads.size(); i += 4)
      for (const std::size_t k : {1U, 2U})
        nearest_m = std::min(nearest_m,
                             meeting_m(eye_m, along, corner(i), corner(i + k), corner(i + k + 1)));
  }
  return nearest_m;
}

TEST(StandingBlades, AreMetWhereTheNearestOfAllFacesIs) {
  const landscape::Landscape landscape = thickets();
  const StandingBlades blades(landscape);
  int met = 0;
  for (std::uint64_t k = 0; k < 3000; ++k) {
    const glm::dvec3 eye_m(1.5 * random_number("ex", k), -0.5, 0.8 * random_number("ez", k));
    const glm::dvec3 along = glm::normalize(glm::dvec3(
        random_number("ax", k) - 0.5, 0.2 + random_number("ay", k), random_number("az", k) - 0.6));
    const double want_m = every_face_m(landscape, eye_m, along);
    const BladeHit hit = blades.look(eye_m, along, infinite);
    if (!std::isfinite(want_m)) {
      ASSERT_FALSE(std::isfinite(hit.distance_m)) << k;
      continue;
    }
    ++met;
    ASSERT_NEAR(hit.distance_m, want_m, 1e-6) << k;
    ASSERT_LT(glm::dot(hit.normal, along), 0.0) << k;
    EXPECT_FALSE(std::isfinite(blades.look(eye_m, along, 0.999 * want_m).distance_m)) << k;
  }
  EXPECT_GT(met, 300);
}

TEST(StandingBlades, ShowTheirOwnDepthNormalAndAlbedo) {
  const test::TemporaryFolder folder("passes_pillar");
  landscape::Landscape landscape = test::constant_meadow({}, folder.path());
  landscape.cells.clear();
  for (float& height_m : landscape.terrain.values()) height_m = 0.0F;
  glm::dmat4 world_from_cell(1.0);
  world_from_cell[3] = {1.0, 1.5, 0.0, 1.0};
  landscape.blade_cells = {{world_from_cell, 0, {}, {{2, 3}, 0}}};
  const LayeredImage image = paint(landscape, test::plain_facts(landscape), passes_of("all"));
  const auto value = [&](const char* channel, std::size_t pixel) {
    return image.find(channel)->values[pixel];
  };
  int front = 0;
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
    if (value("instance.X", pixel) < 0.0F) continue;
    EXPECT_EQ(value("instance.X", pixel), 2.0F);
    EXPECT_EQ(value("instance.Y", pixel), 3.0F);
    // 10 cm wide about the cell's middle; reflectance and transmittance are 0.3 and 0.2.
    EXPECT_NEAR(value("albedo.G", pixel), 0.5, 1e-3);
    if (std::abs(value("position.Y", pixel) - 1.70F) > 1e-4F) continue;
    ++front;
    EXPECT_NEAR(value("position.X", pixel), 1.25, 0.0501);
    EXPECT_LT(value("position.Z", pixel), 0.3001F);
    EXPECT_NEAR(value("normal.Y", pixel), -1.0, 1e-3);
  }
  EXPECT_GT(front, 20);
}

}  // namespace
}  // namespace wold::passes
