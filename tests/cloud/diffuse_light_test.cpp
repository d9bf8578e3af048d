#include "cloud/diffuse_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cloud/scattering.h"

namespace wold::cloud {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double asymmetry = 0.85;  // of droplets in cumulus and stratus

/// A level slab of droplets of an optical depth, lit by the sun or by an even sky above it.
ScatteringBox slab(double depth, double sun_cosine) {
  constexpr int planes = 64;
  ScatteringBox slab;
  slab.box = {{}, {10.0, 10.0, 10.0}, {8, 8, planes}, true};
  slab.asymmetry = asymmetry / (1.0 + asymmetry);
  const double outside_peak = (1.0 - asymmetry * asymmetry) * depth;
  slab.extinction_per_m.assign(slab.box.count(),
                               static_cast<float>(outside_peak / (10.0 * planes)));
  slab.sunlight.assign(slab.box.count(), 0.0F);
  if (sun_cosine <= 0.0) {
    for (std::size_t i = 0; i < ordinate_count; ++i)
      if (ordinates()[i].z < 0.0) slab.arriving[i] = glm::vec3(1.0F);
    return slab;
  }
  slab.sun_irradiance = glm::vec3(1.0F);
  slab.sun_direction = {std::sqrt(1.0 - sun_cosine * sun_cosine), 0.0, sun_cosine};
  for (std::size_t i = 0; i < slab.sunlight.size(); ++i) {
    const double above = (planes - 0.5 - static_cast<double>(i / 64)) / planes;
    slab.sunlight[i] = static_cast<float>(std::exp(-outside_peak * above / sun_cosine));
  }
  return slab;
}

/// Flux that goes down through the slab at a voxel, of what comes to its top.
double flux_down(const ScatteringBox& slab, const std::vector<LightMoments>& light,
                 std::size_t voxel) {
  const double diffuse = -4.0 * pi * double{light[voxel].flux[2].g};
  if (slab.sun_irradiance.g > 0.0F)
    return diffuse / slab.sun_direction.z + double{slab.sunlight[voxel]};
  double arriving = 0.0;
  for (const glm::dvec3& ordinate : ordinates()) arriving += std::max(0.0, -ordinate.z);
  return diffuse / (4.0 * pi * arriving / ordinate_count);
}

/// Fraction of the light that a slab lets through.
double transmittance(double depth, double sun_cosine) {
  const ScatteringBox lit = slab(depth, sun_cosine);
  const std::vector<LightMoments> light = diffuse_light(lit);
  double sum = 0.0;
  for (std::size_t voxel = 0; voxel < light.size(); ++voxel) sum += flux_down(lit, light, voxel);
  return sum / static_cast<double>(light.size());
}

/// Of a deep slab under an even sky: van de Hulst 1980, Multiple Light Scattering, from the
/// diffusion domain and Milne's extrapolation length.
double deep_transmittance(double depth) { return 1.0 / (0.75 * (1.0 - asymmetry) * depth + 1.07); }

TEST(DiffuseLight, OfDeepSlabsUnderAnEvenSkyIsThatOfTheDiffusionDomain) {
  for (const double depth : {10.0, 20.0, 50.0, 100.0}) {
    const double wanted = deep_transmittance(depth);
    EXPECT_NEAR((1.0 - transmittance(depth, 0.0)) / (1.0 - wanted), 1.0, 0.05) << depth;
  }
}

// The sun's part follows from the escape function, 3/7 (1 + 2 mu): Kokhanovsky 2006, Cloud Optics.
TEST(DiffuseLight, OfDeepSlabsUnderTheSunFollowsTheEscapeFunction) {
  for (const double cosine : {0.3, 0.5, 0.8, 1.0})
    for (const double depth : {10.0, 20.0, 50.0, 100.0}) {
      const double wanted = 3.0 / 7.0 * (1.0 + 2.0 * cosine) * deep_transmittance(depth);
      EXPECT_NEAR((1.0 - transmittance(depth, cosine)) / (1.0 - wanted), 1.0, 0.05)
          << cosine << " " << depth;
    }
}

// Nothing is absorbed: what goes down is the same at all heights.
/// A bar of droplets, of an optical depth across both ways, with the sun before its end.
ScatteringBox bar(double depth) {
  constexpr int across = 24, along = 72;
  ScatteringBox bar;
  bar.box = {{}, {10.0, 10.0, 10.0}, {along, across, across}, false};
  bar.asymmetry = asymmetry / (1.0 + asymmetry);
  const double outside_peak = (1.0 - asymmetry * asymmetry) * depth / across;
  bar.extinction_per_m.assign(bar.box.count(), static_cast<float>(outside_peak / 10.0));
  bar.sun_irradiance = glm::vec3(1.0F);
  bar.sun_direction = {-1.0, 0.0, 0.0};
  for (std::size_t i = 0; i < bar.box.count(); ++i)
    bar.sunlight.push_back(
        static_cast<float>(std::exp(-outside_peak * (static_cast<double>(i % along) + 0.5))));
  return bar;
}

/// Of the light in a bar, whose modes are products of two slabs', what the law of the clouds seen
/// as heaps counts on.
TEST(DiffuseLight, FallsAlongABarAsTheSlowestModeDoes) {
  for (const double depth : {30.0, 60.0}) {
    const ScatteringBox lit = bar(depth);
    const std::vector<LightMoments> light = diffuse_light(lit);
    const auto middle = [&](int x) { return double{light[lit.box.index({x, 12, 12})].mean.g}; };
    const double per_voxel = std::log(middle(20) / middle(40)) / 20.0;
    const double expected = std::sqrt(2.0) * decay_along_slab(asymmetry, depth) * depth / 24.0;
    EXPECT_NEAR(per_voxel, expected, 0.1 * expected) << depth;
  }
}

TEST(DiffuseLight, IsNotLostOnItsWayThroughASlab) {
  const ScatteringBox lit = slab(30.0, 0.7);
  const std::vector<LightMoments> light = diffuse_light(lit);
  const double whole = transmittance(30.0, 0.7);
  for (std::size_t voxel = 0; voxel < light.size(); voxel += 64)
    EXPECT_NEAR(flux_down(lit, light, voxel), whole, 0.02) << voxel / 64;
}

}  // namespace
}  // namespace wold::cloud
