#include "grass/optics/shading.h"

#include <gtest/gtest.h>

#include <numeric>

#include "grass/texel/baking.h"
#include "grass/texel/rasterise.h"
#include "rotated.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

using test::degree;

glm::vec3 in_plane(double angle_deg) {
  return {std::cos(angle_deg * degree), 0.0F, std::sin(angle_deg * degree)};
}

constexpr glm::vec3 along_x(1.0F, 0.0F, 0.0F);

TEST(KajiyaKay, DiffuseIsTheSineWithAMeanOfOne) {
  EXPECT_NEAR(kajiya_kay_diffuse(along_x, along_x), 0.0F, 1e-3F);
  EXPECT_NEAR(
      kajiya_kay_diffuse(along_x, in_plane(30.0)) / kajiya_kay_diffuse(along_x, in_plane(90.0)),
      0.5F, 1e-5F);
  const glm::vec3 tangent = glm::normalize(glm::vec3(1.0F, 2.0F, -0.5F));
  double sum = 0.0;
  constexpr int rows = 200;
  constexpr int columns = 100;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double z = (row + 0.5) / rows * 2.0 - 1.0;
      const double azimuth = 2.0 * test::pi * column / columns;
      sum += double{kajiya_kay_diffuse(tangent, glm::vec3(direction_at(std::asin(z), azimuth)))};
    }
  EXPECT_NEAR(sum / (rows * columns), 1.0, 1e-3);
}

// A highlight is a part of what a leaf reflects, so that all directions together get the same.
TEST(SourceRadiance, KeepsEnergyWithAHighlight) {
  const glm::vec3 tangent = glm::normalize(glm::vec3(0.3F, 0.2F, 1.0F));
  const auto sent = [&](float specular) {
    double sum = 0.0;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
      Lighting lighting = test::slanting_light();
      lighting.eye_direction =
          direction_at(std::asin((i + 0.5) / count * 2.0 - 1.0), 2.39996323 * i);
      const Fibre fibre{tangent, glm::vec3(0.4F), glm::vec3(0.15F), specular};
      sum += double{source_radiance(fibre, TurnedLight(lighting, 0), 1.0F, {}, 24.0F).g} / count;
    }
    return sum;
  };
  EXPECT_NEAR(sent(0.5F) / sent(0.0F), 1.0, 0.02);
}

// The mirror cone: light at an angle to the fibre is thrown on at the same angle.
TEST(KajiyaKay, HighlightPeaksOnTheMirrorCone) {
  EXPECT_NEAR(kajiya_kay_specular(along_x, in_plane(90.0), in_plane(90.0), 24.0F), 1.0F, 1e-5F);
  EXPECT_NEAR(kajiya_kay_specular(along_x, in_plane(30.0), in_plane(150.0), 24.0F), 1.0F, 1e-4F);
  // All around the cone, not just in the plane of fibre and light.
  const glm::vec3 around(std::cos(150.0 * degree), std::sin(150.0 * degree), 0.0F);
  EXPECT_NEAR(kajiya_kay_specular(along_x, in_plane(30.0), around, 24.0F), 1.0F, 1e-4F);
  // Ten degrees off it, cos(10)^gloss is left.
  EXPECT_NEAR(kajiya_kay_specular(along_x, in_plane(30.0), in_plane(140.0), 24.0F),
              std::pow(std::cos(10.0 * degree), 24.0), 1e-4);
  EXPECT_EQ(kajiya_kay_specular(along_x, in_plane(10.0), in_plane(20.0), 24.0F), 0.0F);
}

TEST(SkyRings, CoverTheHemisphere) {
  double solid_angle = 0.0;
  double irradiance = 0.0;
  for (const SkyRing& ring : sky_rings()) {
    solid_angle += 4.0 * ring.solid_angle;
    irradiance += 4.0 * ring.solid_angle * std::sin(ring.elevation);
  }
  EXPECT_NEAR(solid_angle, 2.0 * test::pi, 1e-9);
  EXPECT_NEAR(irradiance / test::pi, 1.0, 1e-9);  // of a horizontal plane under radiance 1
}

// The sky turns with the sun: where the sun stands it has the radiance that it had there.
TEST(SkyRings, TurnAsTheSunDoes) {
  Lighting lighting{{0.0, 0.0, 1.0}, glm::vec3(0.0F), {}, {1.0, 0.0, 0.0}};
  for (std::size_t i = 0; i < sky_size(); ++i)
    lighting.sky_radiance.emplace_back(static_cast<float>(i));
  for (const SkyDirection& there : sky_directions(lighting)) {
    lighting.sun_direction = there.direction;
    for (int turn = 0; turn < 4; ++turn) {
      const Lighting seen = turned(lighting, turn);
      EXPECT_LT(glm::distance(seen.sun_direction, TurnedLight(lighting, turn).sun), 1e-9);
      int found = 0;
      for (const SkyDirection& here : sky_directions(seen))
        if (glm::distance(here.direction, seen.sun_direction) < 1e-9) {
          EXPECT_EQ(here.radiance, there.radiance);
          ++found;
        }
      EXPECT_EQ(found, 1);
    }
  }
}

// Under a low sun the sky is brightest about the sun.
TEST(SkyRings, AreBrightestOnTheSunsSide) {
  scene::Scene scene;
  scene.sun.azimuth_deg = 135.0;
  scene.sun.elevation_deg = 15.0;
  const light::Daylight day(scene.sun, scene.sky);
  const Lighting lighting = make_lighting(day, {1.0, 0.0, 0.0}, glm::vec3(0.0F));
  const auto towards_sun = [&](const SkyDirection& sky) {
    return sky.direction.x > 0.0 && sky.direction.y < 0.0;  // the south-east
  };
  glm::vec3 at_sun(0.0F), elsewhere(0.0F);
  for (const SkyDirection& sky : sky_directions(lighting)) {
    if (sky.direction.z > 0.3) continue;
    (towards_sun(sky) ? at_sun : elsewhere) += sky.radiance;
  }
  EXPECT_GT(at_sun.b, 1.5F * elsewhere.b / 3.0F);
}

/// Voxels far apart, too thin to shadow, with fibres evenly in all directions (Fibonacci).
Texel thin_fibres(int count) {
  Texel texel;
  texel.shape = {62, 62, 0.004};
  for (int i = 0; i < count; ++i) {
    texel.voxel.push_back(static_cast<std::uint32_t>(i * 997));
    texel.density.push_back(1e-4F);
    texel.tangent.emplace_back(
        direction_at(std::asin((i + 0.5) / count * 2.0 - 1.0), 2.39996323 * i));
    texel.normal.emplace_back(0.0F);
    texel.albedo.emplace_back(0.01F, 0.005F, 0.0F);
    texel.transmittance.emplace_back(0.005F, 0.0025F, 0.0F);
    texel.specular.push_back(0.0F);
  }
  return texel;
}

// Single scattering from a sky of radiance L over half the sphere: albedo L / 2 on average.
TEST(Bake, UniformSkyGivesItsRadianceTimesHalfTheAlbedo) {
  const Texel texel = thin_fibres(200);
  const Lighting light{{0.0, 0.0, 1.0},
                       glm::vec3(0.0F),
                       std::vector<glm::vec3>(sky_size(), glm::vec3(2.0F)),
                       {1.0, 0.0, 0.0}};
  const auto emission = bake_emission(texel, texel.density, light, {24.0F, 0.0045}, 0);
  glm::dvec3 mean(0.0);
  for (std::size_t i = 0; i < emission.size(); ++i) {
    mean += glm::dvec3(emission[i]) / static_cast<double>(emission.size());
    EXPECT_NEAR(emission[i].r / 0.01F, 1.0F, 0.05F) << "fibre " << texel.tangent[i].z;
  }
  EXPECT_NEAR(mean.r / 0.01, 1.0, 0.02);
  EXPECT_NEAR(mean.g / 0.005, 1.0, 0.02);
  EXPECT_EQ(mean.b, 0.0);
}

// Leaves that stand in all directions alike and reflect as much as they let through (Ross 1981, The
// Radiation Regime and Architecture of Plant Stands): of the albedo a, a (8 / (3 pi) (sin b - b cos
// b) + 4 / 3 cos b) goes into an angle b to the light's way, over the mean of all.
TEST(Bake, UnshadowedSunlight) {
  const Texel texel = thin_fibres(200);
  const Lighting light{direction_at(0.6, 0.2), glm::vec3(3.0F),
                       std::vector<glm::vec3>(sky_size(), glm::vec3(0.0F)), direction_at(0.2, 1.0)};
  const auto emission = bake_emission(texel, texel.density, light, {24.0F, 0.0045}, 0);
  double mean = 0.0;
  for (const glm::vec3& value : emission)
    mean += double{value.r} / static_cast<double>(emission.size());
  const double cosine = -glm::dot(light.sun_direction, light.eye_direction);
  const double angle = std::acos(cosine);
  const double phase =
      8.0 / (3.0 * test::pi) * (std::sin(angle) - angle * cosine) + 4.0 / 3.0 * cosine;
  EXPECT_NEAR(mean / (phase * 0.01 * 3.0 / (4.0 * test::pi)), 1.0, 0.02);
}

TEST(Bake, TurnedTexelIsThatOfTheTurnedMeadow) {
  const TexelShape shape = test::small_shape(30);
  const AgeingModel model({}, 0.12);
  const auto blades = test::small_blades();
  PointDynamics dynamics(model, blades, sample_points(blades, shape, 6.0, 5), 0.0);
  dynamics.advance_to(0.4);
  const Lighting light = test::slanting_light();
  const auto baked = [&](const Texel& texel, int turn) {
    return bake_emission(texel, texel.density, light, {24.0F, 0.0045}, turn);
  };
  const Texel still = rasterise_points(dynamics.points(), shape);
  Texel texel = still;
  std::vector<std::size_t> from(texel.size());
  std::iota(from.begin(), from.end(), std::size_t{0});
  for (int turn = 1; turn <= 3; ++turn) {
    const auto step = test::quarter_turned(texel.shape, texel.voxel).from;
    std::vector<std::size_t> combined;
    for (std::size_t i : step) combined.push_back(from[i]);
    from = combined;
    texel = test::quarter_turned(texel);
    const auto want = baked(texel, 0);
    const auto got = baked(still, turn);
    const auto unturned = baked(still, 0);
    double apart = 0.0;
    for (std::size_t i = 0; i < want.size(); ++i) {
      ASSERT_LT(glm::distance(got[from[i]], want[i]), 1e-5F + 1e-3F * glm::length(want[i]));
      apart += double{glm::distance(unturned[from[i]], want[i])} / static_cast<double>(want.size());
    }
    EXPECT_GT(apart, 1e-3);  // the sun does make a difference
  }
}

// A sun that has set lights nothing, from below least of all; one that grazes the grass casts
// shadows of some length.
TEST(MakeLighting, HasASunAboveTheGround) {
  const auto lighting = [](double elevation_deg) {
    return make_lighting(light::Daylight({elevation_deg, 250.0}, {2.5}), {0.0, -1.0, 0.0},
                         glm::vec3(0.0F));
  };
  for (const double elevation_deg : {-4.0, -0.1, 0.0, 0.3}) {
    const Lighting now = lighting(elevation_deg);
    EXPECT_NEAR(glm::length(now.sun_direction), 1.0, 1e-12);
    EXPECT_GT(now.sun_direction.z, 0.01);
    EXPECT_LT(now.sun_direction.x, -0.9);
  }
  EXPECT_EQ(lighting(-4.0).sun_irradiance, glm::vec3(0.0F));
  EXPECT_NEAR(lighting(5.0).sun_direction.z, std::sin(5.0 * degree), 1e-12);
}

}  // namespace
}  // namespace wold::grass
