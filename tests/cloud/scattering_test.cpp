#include "cloud/scattering.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "core/random.h"

namespace wold::cloud {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Scattering, PhaseFunctionIsOneOverTheSphere) {
  for (const double g : {-0.3, 0.0, 0.5, 0.86}) {
    double sum = 0.0, mean_cosine = 0.0;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i) {
      const double cosine = -1.0 + (i + 0.5) * 2.0 / steps;
      const double fraction = henyey_greenstein(g, cosine) * 2.0 * pi * 2.0 / steps;
      sum += fraction;
      mean_cosine += fraction * cosine;
    }
    EXPECT_NEAR(sum, 1.0, 1e-4);
    EXPECT_NEAR(mean_cosine, g, 1e-4);
  }
}

TEST(Scattering, TwoStreamReflectsWhatBohrenSaysAndLosesNothing) {
  const double depths[] = {3.6, 10.0, 23.0, 50.0};
  const double reflected[] = {0.274, 0.512, 0.707, 0.840};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(two_stream(0.86, 0.0, depths[i]).back, reflected[i], 1e-3);
    const double through = two_stream(0.86, depths[i], 0.0).onward;
    EXPECT_NEAR(through + reflected[i], 1.0, 1e-3);
    for (double before = 0.0; before <= depths[i]; before += 0.9) {
      const TwoStream inside = two_stream(0.86, before, depths[i] - before);
      EXPECT_NEAR(inside.onward - inside.back, through, 1e-12);  // the net flux is the same
    }
  }
}

/// By differences, of dF+/dt = -(c + loss) F+ + c F- and the same backwards.
TEST(Scattering, TwoStreamThatDecaysFollowsItsEquations) {
  constexpr double g = 0.86, all = 50.0, c = 0.75 * (1.0 - g), step = 1e-3;
  for (const double decay : {0.01, 0.05, 0.3}) {
    const double loss = std::sqrt(c * c + decay * decay) - c;
    const auto at = [&](double before) { return two_stream(g, before, all - before, decay); };
    EXPECT_NEAR(at(0.0).onward, 1.0, 1e-12);
    EXPECT_NEAR(at(all).back, 0.0, 1e-12);
    for (double before = 1.0; before < all; before += 4.0) {
      const TwoStream low = at(before - step), here = at(before), high = at(before + step);
      EXPECT_NEAR((high.onward - low.onward) / (2.0 * step),
                  -(c + loss) * here.onward + c * here.back, 1e-6);
      EXPECT_NEAR((high.back - low.back) / (2.0 * step), (c + loss) * here.back - c * here.onward,
                  1e-6);
      EXPECT_LT(here.onward, two_stream(g, before, all - before).onward);
    }
  }
}

TEST(Scattering, TwoStreamWithoutDecayIsItsLimit) {
  for (const double before : {0.0, 3.0, 40.0}) {
    const TwoStream none = two_stream(0.86, before, 10.0, 0.0);
    const TwoStream hardly = two_stream(0.86, before, 10.0, 1e-5);
    EXPECT_NEAR(hardly.onward, none.onward, 1e-6);
    EXPECT_NEAR(hardly.back, none.back, 1e-6);
  }
}

TEST(Scattering, TwoStreamOfAnyDepthIsFinite) {
  for (const double depth : {0.0, 1e-6, 1e3, 1e7}) {
    const TwoStream far = two_stream(0.86, depth, depth, 0.05);
    EXPECT_GE(far.onward, 0.0);
    EXPECT_LE(far.onward, 1.0);
    EXPECT_GE(far.back, 0.0);
    EXPECT_LE(far.back, far.onward + 1e-12);
  }
}

/// A direction `cosine` away from a unit vector, at an azimuth about it.
glm::dvec3 turned(const glm::dvec3& way, double cosine, double azimuth_rad) {
  const glm::dvec3 off = std::abs(way.z) > 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
  const glm::dvec3 right = glm::normalize(glm::cross(way, off));
  const glm::dvec3 up = glm::cross(right, way);
  return glm::normalize(way * cosine +
                        std::sqrt(1.0 - cosine * cosine) *
                            (right * std::cos(azimuth_rad) + up * std::sin(azimuth_rad)));
}

constexpr std::array<double, 6> middles_deg = {5.0, 10.0, 20.0, 30.0, 50.0, 70.0};
constexpr std::array<double, 6> halves_deg = {1.0, 1.0, 2.0, 2.0, 5.0, 5.0};

/// Radiance, in rings about the light's way, of what a slab's other side sends of light of
/// irradiance 1 that was scattered, from the fates of single photons (Henyey and Greenstein's law
/// inverted as by Witt 1977).
std::array<double, 6> radiance_of_photons(double g, double depth) {
  constexpr std::uint64_t photons = 200000;
  std::array<double, 6> radiance{};
  for (std::uint64_t i = 0; i < photons; ++i) {
    std::uint64_t draws = 0;
    const auto uniform = [&] { return random_uniform({1, key_of("photon"), i, draws++}); };
    glm::dvec3 way(0.0, 0.0, 1.0);
    double at = -std::log(1.0 - uniform());
    int times = 0;
    for (; at >= 0.0 && at <= depth; ++times) {
      const double root = (1.0 - g * g) / (1.0 - g + 2.0 * g * uniform());
      const double cosine = std::clamp((1.0 + g * g - root * root) / (2.0 * g), -1.0, 1.0);
      way = turned(way, cosine, 2.0 * pi * uniform());
      at -= way.z * std::log(1.0 - uniform());
    }
    if (at < 0.0 || times == 0) continue;
    const double angle_deg = std::acos(std::min(way.z, 1.0)) * 180.0 / pi;
    for (std::size_t r = 0; r < middles_deg.size(); ++r)
      if (std::abs(angle_deg - middles_deg[r]) < halves_deg[r]) {
        const auto cosine_at = [&](double deg) { return std::cos(deg * pi / 180.0); };
        const double sphere =
            2.0 * pi *
            (cosine_at(middles_deg[r] - halves_deg[r]) - cosine_at(middles_deg[r] + halves_deg[r]));
        radiance[r] += 1.0 / (photons * sphere * way.z);
      }
  }
  return radiance;
}

TEST(Scattering, ForwardLightIsThatOfPhotonsFollowedOneByOne) {
  constexpr double g = 0.866;
  for (const double depth : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    const auto wanted = radiance_of_photons(g, depth);
    const double even = (two_stream(g, depth, 0.0).onward - in_forward_peak(g, depth)) / pi;
    for (std::size_t r = 0; r < middles_deg.size(); ++r) {
      const double cosine = std::cos(middles_deg[r] * pi / 180.0);
      const double found = forward_through(g, depth, cosine) + even;
      EXPECT_NEAR(found, wanted[r], 0.05 * wanted[r] + 0.03) << depth << " " << middles_deg[r];
    }
  }
}

TEST(Scattering, WhatComesThroughIsTheSourceOnItsWay) {
  for (const double depth : {0.2, 3.0, 9.0})
    for (const double cosine : {1.0, 0.9, 0.3}) {
      constexpr int steps = 4000;
      double sum = 0.0;
      for (int i = 0; i < steps; ++i) {
        const double at = depth * (i + 0.5) / steps;
        sum += forward_source(0.86, at, cosine) * std::exp(at - depth) * depth / steps;
      }
      EXPECT_NEAR(forward_through(0.86, depth, cosine), sum, 1e-4 * sum);
    }
}

TEST(Scattering, TableHasItsLaw) {
  for (const ForwardTable::Law law : {forward_through, forward_source}) {
    const ForwardTable table(law, 0.86);
    for (double depth = 0.003; depth < 30.0; depth *= 1.7)
      for (double angle = 0.0; angle < pi; angle += 0.013) {
        const double cosine = std::cos(angle);
        EXPECT_NEAR(table.at(depth, cosine), law(0.86, depth, cosine),
                    0.01 * law(0.86, depth, 1.0) + 1e-5)
            << depth << " " << angle;
      }
  }
}

}  // namespace
}  // namespace wold::cloud
