#include "grass/optics/scattered_light.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/random.h"
#include "grass/optics/leaf_phase.h"
#include "grass/texel/columns.h"
#include "rotated.h"

namespace wold::grass {
namespace {

using std::numbers::pi;

/// A slab of even matter, 30 voxels a side and as high, of an optical depth from top to bottom.
Scatterer slab(float depth, float albedo) {
  Scatterer matter;
  matter.shape = {30, 30, 0.01};
  const std::size_t size = matter.shape.voxels();
  for (std::size_t v = 0; v < size; ++v) matter.voxel.push_back(static_cast<std::uint32_t>(v));
  matter.extinction_per_m.assign(size, depth / 0.3F);
  matter.albedo.assign(size, glm::vec3(albedo));
  matter.sun_source.assign(size, glm::vec3(0.0F));
  return matter;
}

Lighting even_sky(float radiance) {
  return {{0.0, 0.0, 1.0},
          glm::vec3(0.0F),
          std::vector<glm::vec3>(sky_size(), glm::vec3(radiance)),
          {1.0, 0.0, 0.0}};
}

// In an even light, what swallows none of it cannot be told from nothing: all that arrives but the
// sky's own is the other half.
TEST(ScatteredLight, WhiteMatterOnWhiteGroundKeepsAnEvenLightEven) {
  const ScatteredLight light =
      scattered_light(slab(1.0F, 1.0F), {glm::vec3(1.0F), glm::vec3(0.0F)}, even_sky(1.0F));
  EXPECT_NEAR(light.on_ground.g / pi, 1.0, 0.03);
  // At the bottom all of the light is scattered or comes through, at the top half of it.
  const std::size_t top = light.on_matter.size() - 1;
  EXPECT_NEAR(light.on_matter[top].sum.g / (2.0 * pi), 1.0, 0.05);
  EXPECT_NEAR(light.on_matter[top].flux[2].g / -pi, 1.0, 0.05);
}

TEST(ScatteredLight, BlackMatterLetsThroughWhatItsDepthSays) {
  const ScatteredLight light =
      scattered_light(slab(0.5F, 0.0F), {glm::vec3(0.0F), glm::vec3(0.25F)}, even_sky(1.0F));
  double through = 0.0;
  for (const SkyDirection& sky : sky_directions(even_sky(1.0F)))
    through += double{sky.solid_angle} * sky.direction.z * std::exp(-0.5 / sky.direction.z);
  EXPECT_NEAR(light.on_ground.g, through + 0.25, 0.01 * through);
  for (const DiffuseLight& on : light.on_matter) ASSERT_EQ(on.sum, glm::vec3(0.0F));
}

// Of an even light a leaf takes what falls on it from all sides, and sends the same to all.
TEST(LeafShare, OfAnEvenLightIsTheSameForAllLeavesAndEyes) {
  DiffuseLight light;
  light.add_even(glm::vec3(4.0F * std::numbers::pi_v<float>));
  for (std::uint64_t i = 0; i < 20; ++i) {
    const auto at = [&](const char* of) {
      return random_uniform({1, key_of("leaf"), i, key_of(of)});
    };
    const glm::vec3 tangent(direction_at(std::asin(2.0 * at("z") - 1.0), 2.0 * pi * at("a")));
    const glm::vec3 eye(direction_at(std::asin(2.0 * at("y") - 1.0), 2.0 * pi * at("b")));
    const LeafShare share = leaf_share(light, tangent, eye);
    EXPECT_NEAR(share.taken.g / (4.0 * pi), 1.0, 0.01);
    EXPECT_NEAR(share.reflected.g / share.taken.g, 1.0, 0.02);
    EXPECT_NEAR(share.transmitted.g / share.taken.g, 1.0, 0.02);
  }
}

// The phase is the mean over all angles by which a flat Lambertian leaf may be turned.
TEST(LeafPhase, IsThatOfAFlatLeafTurnedByAnyAngle) {
  const glm::vec3 tangent(0.0F, 0.0F, 1.0F);
  const glm::dvec3 light = direction_at(0.3, 0.0), eye = direction_at(0.7, 2.0);
  constexpr int turns = 2000;
  double reflected = 0.0, transmitted = 0.0, all = 0.0;
  for (int i = 0; i < turns; ++i) {
    const double roll = 2.0 * pi * i / turns;
    const glm::dvec3 normal(std::cos(roll), std::sin(roll), 0.0);
    const double to_light = glm::dot(normal, light), to_eye = glm::dot(normal, eye);
    const double sent = std::abs(to_light * to_eye);
    (to_light * to_eye > 0.0 ? reflected : transmitted) += sent / turns;
    all += sent / turns;
  }
  const LeafPhase phase = leaf_phase(tangent, glm::vec3(light), glm::vec3(eye));
  EXPECT_NEAR(phase.reflected / (phase.reflected + phase.transmitted), reflected / all, 0.005);
  // A mean of 1 about the axis.
  double mean = 0.0;
  for (int i = 0; i < turns; ++i)
    mean += double{leaf_phase(tangent, glm::vec3(light),
                              glm::vec3(direction_at(0.7, 2.0 * pi * i / turns)))
                       .reflected} /
            turns;
  EXPECT_NEAR(mean, 1.0, 0.005);
}

}  // namespace
}  // namespace wold::grass
