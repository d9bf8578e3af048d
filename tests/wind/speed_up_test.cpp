#include "wind/speed_up.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>

#include "wind/fourier.h"

namespace wold::wind {
namespace {

constexpr glm::dvec2 east(1.0, 0.0), north(0.0, 1.0);

Heightfield ground(double size_m, const std::function<double(double, double)>& height_m) {
  Heightfield terrain(513, size_m);
  for (int j = 0; j < terrain.samples(); ++j)
    for (int i = 0; i < terrain.samples(); ++i) {
      const glm::dvec2 at_m = terrain.place_m(i, j);
      terrain.at(i, j) = static_cast<float>(height_m(at_m.x, at_m.y));
    }
  return terrain;
}

/// The bell-shaped ridge of Jackson and Hunt, h / (1 + (x / L)^2), in the middle of its square.
constexpr double half_width_m = 40.0, size_m = 20.0 * half_width_m, hill_height_m = 3.0;

Heightfield ridge() {
  return ground(size_m, [](double x, double /*y*/) {
    const double from_crest = (x - 0.5 * size_m) / half_width_m;
    return hill_height_m / (1.0 + from_crest * from_crest);
  });
}

double change_at(const SpeedUp& speed_up, double from_crest) {
  return speed_up.mean({0.5 * size_m + from_crest * half_width_m, 0.5 * size_m}, east).x - 1.0;
}

/// Jackson and Hunt 1975: h / L (ln(L / z0) / ln(l / z0))^2 on the crest, where
/// l ln(l / z0) = 2 kappa^2 L.
double jackson_and_hunt(double roughness_m) {
  double inner_m = 0.1 * half_width_m;
  for (int step = 0; step < 200; ++step)
    inner_m = 0.5 * (inner_m + 2.0 * 0.16 * half_width_m / std::log(inner_m / roughness_m));
  const double ratio = std::log(half_width_m / roughness_m) / std::log(inner_m / roughness_m);
  return hill_height_m / half_width_m * ratio * ratio;
}

TEST(SpeedUp, OnALowCrestIsJacksonAndHunts) {
  for (const double canopy_m : {0.1, 0.3, 0.8}) {
    const Profile profile(canopy_m);
    const double wanted = jackson_and_hunt(profile.roughness_m());
    EXPECT_NEAR(change_at(SpeedUp(ridge(), profile), 0.0) / wanted, 1.0, 0.15) << canopy_m;
  }
}

// Their sigma(x) = (1 - x^2) / (1 + x^2)^2 changes its sign at x = 1, and is -1/8 at sqrt(3).
TEST(SpeedUp, ShelterAtTheFootIsAnEighth) {
  const SpeedUp speed_up(ridge(), Profile(0.3));
  const double crest = change_at(speed_up, 0.0);
  EXPECT_NEAR(change_at(speed_up, 1.0) / crest, 0.0, 0.08);
  EXPECT_NEAR(change_at(speed_up, -1.0) / crest, 0.0, 0.08);
  EXPECT_NEAR(change_at(speed_up, std::sqrt(3.0)) / crest, -0.125, 0.06);
}

TEST(SpeedUp, LeavesWindAlongARidgeAndOverLevelGroundAsItIs) {
  const SpeedUp along(ridge(), Profile(0.3));
  EXPECT_LT(glm::distance(along.mean({0.5 * size_m, 0.5 * size_m}, north), north), 1e-3);
  const SpeedUp level(ground(100.0, [](double, double) { return 7.0; }), Profile(0.3));
  EXPECT_LT(glm::distance(level.mean({31.0, 54.0}, east), east), 1e-6);
}

// A round hill has the half of a ridge's speed-up per wave: its waves go all ways.
TEST(SpeedUp, GoesRoundHills) {
  const SpeedUp hill(ground(size_m,
                            [](double x, double y) {
                              const double square = (x - 0.5 * size_m) * (x - 0.5 * size_m) +
                                                    (y - 0.5 * size_m) * (y - 0.5 * size_m);
                              return 4.0 * std::exp(-square / (2.0 * 40.0 * 40.0));
                            }),
                     Profile(0.3));
  const glm::dvec2 crest(0.5 * size_m);
  EXPECT_NEAR(hill.mean(crest, east).x, hill.mean(crest, north).y, 1e-3);
  // Left of the hill's foot, seen with the wind, it turns to the left before the hill.
  const glm::dvec2 before = crest + glm::dvec2(-60.0, 60.0);
  const glm::dvec2 behind = crest + glm::dvec2(60.0, 60.0);
  EXPECT_GT(hill.mean(before, east).y, 0.005);
  EXPECT_LT(hill.mean(behind, east).y, -0.005);
}

TEST(SpeedUp, FadesUpwardsAndStaysWithinItsBounds) {
  const SpeedUp low(ridge(), Profile(0.3));
  const glm::dvec2 crest(0.5 * size_m);
  EXPECT_NEAR(low.hill_m() / half_width_m, 1.05, 0.15);  // of exp(-k L): <k> = 1.5 / L
  EXPECT_LT(low.mean(crest, east, low.hill_m()).x - 1.0, 0.06 * change_at(low, 0.0));
  const SpeedUp steep(ground(60.0, [](double x, double) { return x < 30.0 ? 0.0 : 25.0; }),
                      Profile(0.3));
  for (int i = 1; i < 60; ++i) {
    const double along = steep.mean({1.0 * i, 30.0}, east).x;
    EXPECT_GE(along, 0.1 - 1e-9) << i;
    EXPECT_LE(along, 2.0 + 1e-9) << i;
  }
}

TEST(InnerLayer, FollowsItsEquation) {
  for (const double hill_m : {5.0, 200.0, 5000.0}) {
    const double inner_m = inner_layer_m(hill_m, 0.03);
    EXPECT_NEAR(inner_m * std::log(inner_m / 0.03) / (2.0 * 0.16 * hill_m), 1.0, 1e-9);
  }
}

TEST(Fourier, FindsAWaveAndGoesBack) {
  constexpr int side = 16;
  ComplexSquare square{side, {}};
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      square.values.push_back(std::polar(1.0, 2.0 * std::numbers::pi * (3.0 * i + 5.0 * j) / side));
  const ComplexSquare before = square;
  transform(square);
  for (int k = 0; k < side * side; ++k)
    EXPECT_LT(std::abs(square.values[static_cast<std::size_t>(k)] -
                       (k == 5 * side + 3 ? 1.0 * side * side : 0.0)),
              1e-9);
  transform_back(square);
  for (std::size_t k = 0; k < square.values.size(); ++k)
    EXPECT_LT(std::abs(square.values[k] - before.values[k]), 1e-12);
  ComplexSquare odd{12, std::vector<std::complex<double>>(144)};
  EXPECT_THROW(transform(odd), std::invalid_argument);
}

}  // namespace
}  // namespace wold::wind
