#include "grass/optics/flat_leaf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "grass/texel/columns.h"

namespace wold::grass {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
const glm::vec3 tangent = glm::normalize(glm::vec3(0.3F, 0.2F, 1.0F));

/// Sun from the south-east, seen from the south-west.
TurnedLight light() {
  Lighting lighting;
  lighting.sun_direction = glm::normalize(glm::dvec3(0.6, -0.5, 0.7));
  lighting.sun_irradiance = glm::vec3(0.8F);
  lighting.eye_direction = glm::normalize(glm::dvec3(-0.3, -0.9, 0.4));
  return {lighting, 0};
}

/// A clear sky over dark ground.
DiffuseLight sky() {
  DiffuseLight diffuse;
  constexpr int count = 3000;
  for (int i = 0; i < count; ++i)
    diffuse.add(glm::vec3(direction_at(std::asin((i + 0.5) / count), 2.39996323 * i)),
                glm::vec3(2.0F * pi * 0.1F / count));
  return diffuse;
}

/// The mean of value(normal) over all turns about the axis, by what each of them shows to the eye.
template <class Value>
glm::vec3 mean_shown(const glm::vec3& eye, const Value& value) {
  const glm::vec3 east = glm::normalize(glm::cross(tangent, glm::vec3(1, 0, 0)));
  const glm::vec3 north = glm::cross(tangent, east);
  glm::vec3 sum(0.0F);
  float shown = 0.0F;
  constexpr int turns = 720;
  for (int i = 0; i < turns; ++i) {
    const float angle = 2.0F * pi * (static_cast<float>(i) + 0.5F) / turns;
    const glm::vec3 normal = std::cos(angle) * east + std::sin(angle) * north;
    sum += flat_leaf_area(normal, eye) * value(normal);
    shown += flat_leaf_area(normal, eye);
  }
  return sum / shown;
}

// A Lambert leaf square to the sun, seen from there: albedo over pi, whatever its axis.
TEST(FlatLeaf, SquareToTheSunSendsItsReflectanceOverPi) {
  Lighting lighting;
  lighting.sun_direction = lighting.eye_direction = {0.0, -1.0, 0.0};
  lighting.sun_irradiance = glm::vec3(1.0F);
  const Fibre fibre{{0, 0, 1}, glm::vec3(0.5F), glm::vec3(0.2F), 0.0F};
  const glm::vec3 south(0, -1, 0);
  EXPECT_NEAR(flat_leaf_radiance(fibre, south, TurnedLight(lighting, 0), 1.0F, {}, 24.0F).g,
              0.3F / pi, 1e-6F);
  EXPECT_NEAR(flat_leaf_radiance(fibre, -south, TurnedLight(lighting, 0), 1.0F, {}, 24.0F).g,
              0.3F / pi, 1e-6F);
  lighting.eye_direction = {0.0, 1.0, 0.0};
  EXPECT_NEAR(flat_leaf_radiance(fibre, south, TurnedLight(lighting, 0), 1.0F, {}, 24.0F).g,
              0.2F / pi, 1e-6F);
  EXPECT_NEAR(flat_leaf_radiance(fibre, {1, 0, 0}, TurnedLight(lighting, 0), 1.0F, {}, 24.0F).g,
              0.0F, 1e-6F);  // edgewise
}

// Leaves that are turned by any angle are the fibre that source_radiance() has.
TEST(FlatLeaf, TurnedByAnyAngleIsAFibre) {
  const Fibre dull{tangent, glm::vec3(0.4F), glm::vec3(0.15F), 0.0F};
  const auto mean = [&](const Fibre& fibre, float sunlit, const DiffuseLight& diffuse) {
    return mean_shown(light().eye,
                      [&](const glm::vec3& normal) {
                        return flat_leaf_radiance(fibre, normal, light(), sunlit, diffuse, 24.0F);
                      })
        .g;
  };
  const auto fibre_sends = [&](const Fibre& fibre, float sunlit, const DiffuseLight& diffuse) {
    return source_radiance(fibre, light(), sunlit, diffuse, 24.0F).g;
  };
  EXPECT_NEAR(mean(dull, 1.0F, {}) / fibre_sends(dull, 1.0F, {}), 1.0F, 0.01F);
  EXPECT_NEAR(mean(dull, 0.0F, sky()) / fibre_sends(dull, 0.0F, sky()), 1.0F, 0.05F);
  Fibre glossy = dull;
  glossy.specular = 0.5F;
  EXPECT_NEAR(mean(glossy, 0.7F, sky()) / fibre_sends(glossy, 0.7F, sky()), 1.0F, 0.2F);
}

TEST(FlatLeaf, ShowsOnAverageWhatAFibreShows) {
  const glm::vec3 across = glm::normalize(glm::cross(tangent, glm::vec3(1, 0, 0)));
  float sum = 0.0F;
  constexpr int turns = 360;
  for (int i = 0; i < turns; ++i) {
    const float angle = 2.0F * pi * static_cast<float>(i) / turns;
    sum += flat_leaf_area(std::cos(angle) * across + std::sin(angle) * glm::cross(tangent, across),
                          light().eye) /
           turns;
  }
  EXPECT_NEAR(sum, kajiya_kay_diffuse(tangent, light().eye), 1e-3F);
}

// Closed forms: pi of a radiance 1 from everywhere, pi from a half that one faces, half of it where
// one stands square to its border.
TEST(DiffuseLight, LightsTheSidesOfAPlane) {
  DiffuseLight even;
  even.add_even(glm::vec3(4.0F * pi));
  EXPECT_NEAR(irradiance_of_side(even, {0, 0, 1}).g, pi, 1e-4F);
  EXPECT_NEAR(irradiance_of_side(sky(), {0, 0, 1}).g, 0.1F * pi, 0.1F * pi * 0.05F);
  EXPECT_NEAR(irradiance_of_side(sky(), {1, 0, 0}).g, 0.05F * pi, 0.1F * pi * 0.05F);
  EXPECT_NEAR(irradiance_of_side(sky(), {0, 0, -1}).g, 0.0F, 0.1F * pi * 0.05F);
}

}  // namespace
}  // namespace wold::grass
