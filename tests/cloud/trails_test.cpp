#include "cloud/trails.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cloud/clouds.h"

namespace wold::cloud {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int side_px = 128;

/// What one head lets fall, where the others let fall next to nothing.
class OneTrail {
 public:
  explicit OneTrail(const Trails& trails) {
    PeriodicMap<float> heads(side_px, side_px);
    for (int y = -12; y <= 12; ++y)
      for (int x = -12; x <= 12; ++x)
        heads.at(64 + x, 64 + y) = static_cast<float>(6.0 * std::exp(-(x * x + y * y) / 18.0));
    field_ = trailing(heads, trails, 3);
    nothing_ = *std::ranges::min_element(field_.values());
  }

  /// At pixels from the head.
  double ice(int east, int north) const {
    const float at = field_.wrapped(64 + east, 64 + north);
    return std::exp(double{at}) - std::exp(nothing_);
  }

 private:
  PeriodicMap<float> field_;
  double nothing_ = 0.0;
};

// A length of 1/8 of the texture is 16 pixels.
TEST(Trails, FadeByEOverTheirLengthUpwindOfTheirHead) {
  const OneTrail trail({.length = 0.125, .heading_rad = 0.5 * pi});  // the wind blows to the east
  EXPECT_NEAR(trail.ice(-16, 0) / trail.ice(-32, 0), std::exp(1.0), 0.15 * std::exp(1.0));
  EXPECT_NEAR(trail.ice(-24, 0) / trail.ice(-40, 0), std::exp(1.0), 0.15 * std::exp(1.0));
  for (int away = 14; away < 50; away += 4) {
    EXPECT_LT(trail.ice(away, 0), 0.01 * trail.ice(-16, 0)) << away;
    EXPECT_LT(trail.ice(0, away), 0.01 * trail.ice(-16, 0)) << away;
    EXPECT_LT(trail.ice(0, -away), 0.01 * trail.ice(-16, 0)) << away;
  }
}

TEST(Trails, FollowTheWind) {
  const OneTrail to_north({.length = 0.125, .heading_rad = 0.0});
  EXPECT_GT(to_north.ice(0, -16), 100.0 * std::abs(to_north.ice(-16, 0)));
  const OneTrail to_south_west({.length = 0.125, .heading_rad = 1.25 * pi});
  EXPECT_GT(to_south_west.ice(11, 11), 100.0 * std::abs(to_south_west.ice(-11, -11)));
}

// After a length L they are bend * L aside, all of a region to the same side.
TEST(Trails, BendAsTheWindTurns) {
  const OneTrail trail({.length = 0.125, .bend = 0.15, .heading_rad = 0.5 * pi});
  const auto densest_aside = [&](int upwind) {
    int densest = 0;
    for (int north = -40; north <= 40; ++north)
      if (trail.ice(-upwind, north) > trail.ice(-upwind, densest)) densest = north;
    return densest;
  };
  const int near = std::abs(densest_aside(12)), far = std::abs(densest_aside(32));
  EXPECT_GT(far, near + 4);
  EXPECT_LT(far, 30);
}

// A head of one pixel lets fall a line, not a row of dots: along it nothing is off the mean of a
// few pixels by much. Steps that skip pixels would show.
TEST(Trails, AreLinesWithoutDots) {
  constexpr double length = 0.25;
  PeriodicMap<float> heads(256, 256);
  heads.at(128, 128) = 9.0F;
  const PeriodicMap<float> field = trailing(heads, {.length = length, .heading_rad = 1.0}, 3);
  const double nothing = std::exp(double{*std::ranges::min_element(field.values())});
  const glm::dvec2 upwind(-std::sin(1.0), -std::cos(1.0)), aside(upwind.y, -upwind.x);
  std::vector<double> line;  // by half pixels: what falls across it
  for (double away = 24.0; away < 140.0; away += 0.5) {
    double sum = 0.0;
    for (double across = -12.0; across <= 12.0; across += 0.5) {
      const glm::dvec2 at = (glm::dvec2(128.5) + away * upwind + across * aside) / 256.0;
      sum += std::exp(field.sample(at.x, at.y)) - nothing;
    }
    line.push_back(sum);
  }
  for (std::size_t i = 4; i + 4 < line.size(); ++i) {
    double mean = 0.0;
    for (std::size_t j = i - 4; j <= i + 4; ++j) mean += line[j] / 9.0;
    EXPECT_NEAR(line[i], mean, 0.45 * mean) << i;
  }
}

/// Of a layer of cirrus as it is by default.
struct Cirrus {
  CloudState state;
  const Layer& layer;

  explicit Cirrus(double heading_deg = 90.0)
      : state([&] {
          scene::Scene scene;
          scene.clouds.resize(1);
          scene.clouds[0].kind = scene::CloudKind::cirrus;
          scene.clouds[0].heading_deg = heading_deg;
          return Clouds(scene, Clouds::usual_pixel_m(scene.clouds)).at(0.0);
        }()),
        layer(*state.layers[0].layer) {}

  /// Of the ice, not of what is seen.
  double optical_depth(const glm::dvec2& place_m) const {
    return droplets_per_seen(layer) * optical_depth_at(state.layers[0], state.pixel_m, place_m);
  }
};

// Thin cirrus, blue sky shining through, has optical depths of 0.03 to 0.3 (Sassen and Cho 1992,
// Subvisual-thin cirrus lidar dataset for satellite verification and climatological research).
TEST(Cirrus, IsThinWithClearSkyBetween) {
  const Cirrus cirrus;
  std::vector<double> depths;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      depths.push_back(
          cirrus.optical_depth(glm::dvec2(x + 0.5, y + 0.5) / 200.0 * cirrus.layer.period_m));
  std::ranges::sort(depths);
  const auto first_seen = std::ranges::lower_bound(depths, 0.01);
  const std::vector<double> seen(first_seen, depths.end());
  const double share = static_cast<double>(seen.size()) / static_cast<double>(depths.size());
  EXPECT_GT(share, 0.3);
  EXPECT_LT(share, 0.6);
  EXPECT_GT(seen[seen.size() / 2], 0.03);
  EXPECT_LT(seen[seen.size() / 2], 0.3);
  EXPECT_LT(seen[seen.size() * 9 / 10], 0.6);
}

// Fibres are much longer than wide, along the wind give or take its turn with height.
TEST(Cirrus, IsCombedByTheWind) {
  for (const double heading_deg : {20.0, 110.0}) {
    const Cirrus cirrus(heading_deg);
    std::vector<double> steps;  // mean squared step by direction, in twelfths of a half turn
    for (int direction = 0; direction < 12; ++direction) {
      const double angle = pi * direction / 12.0;
      const glm::dvec2 step_m = 250.0 * glm::dvec2(std::sin(angle), std::cos(angle));
      double sum = 0.0;
      for (int i = 0; i < 20000; ++i) {
        const glm::dvec2 place_m(i * 977 % 128000, i * 3571L % 128000);
        const double step = cirrus.optical_depth(place_m + step_m) - cirrus.optical_depth(place_m);
        sum += step * step;
      }
      steps.push_back(sum);
    }
    const auto along = std::ranges::min_element(steps);
    EXPECT_GT(*std::ranges::max_element(steps), 3.0 * *along);
    const double along_deg = 15.0 * static_cast<double>(along - steps.begin());
    const double apart = std::remainder(along_deg - heading_deg, 180.0);
    EXPECT_LT(std::abs(apart), 55.0) << heading_deg;
  }
}

}  // namespace
}  // namespace wold::cloud
