#include "terrain/made_up_land.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/elementary.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

constexpr double hurst = 0.7;
constexpr double largest_feature_m = 8000.0, smallest_copy_m = 5.0;
constexpr double largest_deviation_m = 300.0;

double deviation_of(const Heightfield& ground) {
  double sum = 0.0, squares = 0.0;
  for (const float height_m : ground.values()) {
    sum += double{height_m};
    squares += double{height_m} * double{height_m};
  }
  const double count = static_cast<double>(ground.values().size());
  return std::sqrt(std::max(0.0, squares / count - (sum / count) * (sum / count)));
}

/// What soil that creeps leaves of features of a size.
double soft(double feature_m) {
  constexpr double creep_m = 25.0;
  return feature_m / (feature_m + creep_m);
}

/// What is left of features that are smaller than valleys where those are so steep, over their
/// mean.
double weight_on(double steepness) {
  constexpr double on_slopes = 0.6;
  return on_slopes * std::clamp(steepness, 0.0, 1.0);
}

}  // namespace

MadeUpLand::MadeUpLand(const Heightfield& ground, std::uint64_t seed) {
  const double half_m = 0.5 * ground.size_m(), largest_m = std::max(half_m, largest_feature_m);
  const std::uint64_t key = random_bits({seed, key_of("ground"), 0, key_of("made-up land")});
  const glm::dmat2 turn(0.8, 0.6, -0.6, 0.8);  // no copy lies along another
  const double deviation_m = deviation_of(ground);
  if (deviation_m <= 0.0) return;
  worn_.emplace(key);
  Copy copy{.feature_m = largest_m,
            .height_m =
                std::min(deviation_m * math::pow(largest_m / half_m, hurst), largest_deviation_m)};
  for (std::uint64_t i = 0; copy.feature_m >= smallest_copy_m; ++i) {
    const auto drawn = [&](std::string_view what) {
      return WornLand::period * random_uniform({key, key_of("copy"), i, key_of(what)});
    };
    copy.shift = {drawn("east"), drawn("north")};
    copies_.push_back(copy);
    copy.feature_m *= math::exp2(-1.0 * WornLand::octaves);
    copy.height_m *= math::exp2(-hurst * WornLand::octaves);
    copy.turn = turn * copy.turn;
  }
}

double MadeUpLand::height_m(const glm::dvec2& at_m, double step_m, double from_known_m) const {
  constexpr double shows_nothing_m = std::numeric_limits<double>::infinity();
  return finer_m(at_m, {shows_nothing_m, step_m}, from_known_m);
}

double MadeUpLand::finer_m(const glm::dvec2& at_m, const Steps& steps, double from_known_m) const {
  double sum_m = 0.0, weight = 1.0;
  if (steps.fine_m >= steps.coarse_m) return sum_m;
  for (const Copy& copy : copies_) {
    const glm::dvec2 place = copy.place(at_m);
    double feature_m = copy.feature_m, begun = 0.0;
    for (int octave = 0; octave < WornLand::octaves; ++octave, feature_m *= 0.5) {
      const double fine = shown_fraction(feature_m, steps.fine_m);
      if (fine <= 0.0) return sum_m;
      begun = glm::smoothstep(0.0, feature_m, from_known_m);
      const double part = begun * (fine - shown_fraction(feature_m, steps.coarse_m));
      if (part > 0.0)
        sum_m += weight * part * copy.height_m * soft(feature_m) * worn_->height(octave, place);
    }
    weight *= std::lerp(1.0, weight_on(worn_->steepness(place)), begun);
  }
  return sum_m;
}

double MadeUpLand::most_finer_m(const Steps& steps) const {
  double sum_m = 0.0;
  for (const Copy& copy : copies_) {
    double feature_m = copy.feature_m;
    for (int octave = 0; octave < WornLand::octaves; ++octave, feature_m *= 0.5) {
      const double part =
          shown_fraction(feature_m, steps.fine_m) - shown_fraction(feature_m, steps.coarse_m);
      sum_m += std::max(part, 0.0) * copy.height_m * soft(feature_m) * worn_->highest(octave);
    }
  }
  return sum_m;
}

}  // namespace wold::terrain
