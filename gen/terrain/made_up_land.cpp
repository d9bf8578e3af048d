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
constexpr double largest_feature_m = 8000.0, smallest_feature_m = 5.0;
constexpr double largest_deviation_m = 500.0;

/// Over which soil that creeps rounds crests, and how fast noise of deviation 1 changes on them,
/// per size of features.
constexpr double crest_m = 25.0, steepness = 4.0;

/// What is left for features where no larger ones have begun that could hold them down. So land is
/// as high as its law has it, beside known land too.
constexpr double weight_beside_known = 0.6;

double deviation_of(const Heightfield& ground) {
  double sum = 0.0, squares = 0.0;
  for (const float height_m : ground.values()) {
    sum += double{height_m};
    squares += double{height_m} * double{height_m};
  }
  const double count = static_cast<double>(ground.values().size());
  return std::sqrt(std::max(0.0, squares / count - (sum / count) * (sum / count)));
}

/// What is left for the features within features of that height.
double weight_within(double signal) { return std::clamp(1.6 * signal, 0.0, 1.0); }

}  // namespace

MadeUpLand::MadeUpLand(const Heightfield& ground, std::uint64_t seed) {
  const double half_m = 0.5 * ground.size_m(), largest_m = std::max(half_m, largest_feature_m);
  deviation_m_ =
      std::min(deviation_of(ground) * math::pow(largest_m / half_m, hurst), largest_deviation_m);
  const std::uint64_t key = random_bits({seed, key_of("ground"), 0, key_of("made-up land")});
  const glm::dmat2 turn(0.8, 0.6, -0.6, 0.8);  // no octave's lattice lies along another's
  Octave octave{.feature_m = largest_m, .part = 1.0};
  for (std::uint64_t i = 0; octave.feature_m >= smallest_feature_m; ++i) {
    const auto drawn = [&](std::string_view what) {
      return RandomKey{key, key_of("octave"), i, key_of(what)};
    };
    octave.round = steepness * crest_m / octave.feature_m;
    octave.shift = {random_uniform(drawn("east")), random_uniform(drawn("north"))};
    octave.key = random_bits(drawn("noise"));
    octaves_.push_back(octave);
    octave.feature_m *= 0.5;
    octave.part *= math::exp2(-hurst);
    octave.turn = turn * octave.turn;
  }
  measure();
}

double MadeUpLand::ridge(const Octave& octave, const glm::dvec2& at_m) {
  const double noise =
      gradient_noise(octave.turn * at_m / octave.feature_m + octave.shift, octave.key);
  const double sharp = noise / gradient_noise_deviation;
  const double away = std::sqrt(sharp * sharp + octave.round * octave.round) - octave.round;
  const double height = std::max(0.0, 1.0 - 0.45 * away);
  return height * height;
}

/// Means over places, and the deviation of the sum.
void MadeUpLand::measure() {
  constexpr int side = 64;
  constexpr double features = 16.0;
  const double count = side * side, step_m = features * octaves_.front().feature_m / side;
  std::vector<double> sums(side * side, 0.0), weights(side * side, 1.0);
  for (Octave& octave : octaves_) {
    for (std::size_t i = 0; i < sums.size(); ++i) {
      const double ridge_here = ridge(octave, step_m * glm::dvec2(i % side, i / side));
      octave.mean_ridge += ridge_here / count;
      octave.mean_weight += weights[i] / count;
      sums[i] += octave.part * ridge_here * weights[i];
      weights[i] = weight_within(ridge_here * weights[i]);
    }
  }
  double mean = 0.0, square = 0.0;
  for (const double sum : sums) {
    mean += sum / count;
    square += sum * sum / count;
  }
  scale_ = 1.0 / std::sqrt(square - mean * mean);
}

double MadeUpLand::height_m(const glm::dvec2& at_m, double step_m, double from_known_m) const {
  double sum = 0.0;
  double weight = 1.0;        // where all features have begun
  double larger_begun = 1.0;  // how far the next larger ones have
  for (const Octave& octave : octaves_) {
    const double shown = shown_fraction(octave.feature_m, step_m);
    if (shown <= 0.0) break;
    const auto left = [&](double where_all_have_begun) {
      return std::lerp(weight_beside_known, where_all_have_begun, larger_begun);
    };
    const double begun = glm::smoothstep(0.0, octave.feature_m, from_known_m);
    const double here = ridge(octave, at_m);
    sum += begun * shown * octave.part *
           (here * left(weight) - octave.mean_ridge * left(octave.mean_weight));
    weight = weight_within(here * weight);
    larger_begun = begun;
  }
  return deviation_m_ * scale_ * sum;
}

}  // namespace wold::terrain
