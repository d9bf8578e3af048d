#include "terrain/made_up_land.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/elementary.h"
#include "core/noise.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

constexpr double hurst = 0.7;
constexpr double largest_feature_m = 8000.0, largest_deviation_m = 500.0;

double deviation_of(const Heightfield& ground) {
  double sum = 0.0, squares = 0.0;
  for (const float height_m : ground.values()) {
    sum += double{height_m};
    squares += double{height_m} * double{height_m};
  }
  const double count = static_cast<double>(ground.values().size());
  return std::sqrt(std::max(0.0, squares / count - (sum / count) * (sum / count)));
}

}  // namespace

MadeUpLand::MadeUpLand(const Heightfield& ground, std::uint64_t seed)
    : key_(random_bits({seed, key_of("ground"), 0, key_of("made-up land")})),
      feature_m_(std::max(0.5 * ground.size_m(), largest_feature_m)),
      deviation_m_(
          std::min(deviation_of(ground) * math::pow(feature_m_ / (0.5 * ground.size_m()), hurst),
                   largest_deviation_m)) {
  constexpr int places = 64;  // along a side
  constexpr double features = 16.0;
  double sum = 0.0, squares = 0.0;
  for (int j = 0; j < places; ++j)
    for (int i = 0; i < places; ++i) {
      const glm::dvec2 at_m = glm::dvec2(i, j) * (features * feature_m_ / places);
      const double value = multifractal(at_m, 0.02 * feature_m_);
      sum += value;
      squares += value * value;
    }
  mean_ = sum / (places * places);
  scale_ = 1.0 / std::sqrt(squares / (places * places) - mean_ * mean_);
}

double MadeUpLand::height_m(const glm::dvec2& at_m, double step_m) const {
  return deviation_m_ * scale_ * (multifractal(at_m, step_m) - mean_);
}

double MadeUpLand::multifractal(const glm::dvec2& at_m, double step_m) const {
  constexpr int most_octaves = 9;
  const double lower = math::exp2(-hurst);     // each octave than the one before
  const glm::dmat2 turn(0.8, 0.6, -0.6, 0.8);  // no octave's lattice lies along another's
  double sum = 0.0, weight = 1.0, part = 1.0, feature_m = feature_m_;
  glm::dvec2 place_m = at_m;
  for (std::uint64_t octave = 0; octave < most_octaves; ++octave) {
    const double shown = shown_fraction(feature_m, step_m);
    if (shown <= 0.0) break;
    const auto drawn = [&](std::string_view what) {
      return RandomKey{key_, key_of("octave"), octave, key_of(what)};
    };
    const glm::dvec2 shift(random_uniform(drawn("east")), random_uniform(drawn("north")));
    const double noise = gradient_noise(place_m / feature_m + shift, random_bits(drawn("noise")));
    const double ridge = std::max(0.0, 1.0 - 0.45 * std::abs(noise / gradient_noise_deviation));
    const double signal = ridge * ridge * weight;
    sum += shown * part * signal;
    weight = std::clamp(1.6 * signal, 0.0, 1.0);
    part *= lower;
    feature_m *= 0.5;
    place_m = turn * place_m;
  }
  return sum;
}

}  // namespace wold::terrain
