#include "terrain/finer_relief.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/elementary.h"
#include "core/noise.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

/// Of gradient noise whose power lies in waves of one to two lengths: its features, in the longest.
constexpr double feature_of_waves = 0.6;
/// The shortest waves, metres, that creeping soil leaves.
constexpr double min_wave_m = 0.7;

/// Noise of deviation 1 as a mean of places along a way, its gradient per unit: `along`, in
/// features, at most 0.8 long.
NoiseSlope carried_noise(const glm::dvec2& at, const glm::dvec2& along, std::uint64_t key) {
  NoiseSlope sum;
  for (int tap = -1; tap <= 1; ++tap) {
    const NoiseSlope noise = gradient_noise_slope(at + 1.0 * tap * along, key);
    sum.value += noise.value;
    sum.gradient += noise.gradient;
  }
  // What the mean of the three keeps of the variance: a fit, true to 1 %.
  const double length2 = glm::dot(along, along);
  const double kept = 1.0 / (1.0 + (6.2685 - 3.6166 * length2) * length2);
  const double scale = 1.0 / (3.0 * gradient_noise_deviation * std::sqrt(kept));
  return {sum.value * scale, sum.gradient * scale};
}

GroundMap<glm::vec2> gradients(const GroundMap<double>& heights_m) {
  GroundMap<glm::vec2> map(heights_m.samples(), heights_m.square());
  const int last = heights_m.samples() - 1;
  for (int j = 0; j <= last; ++j)
    for (int i = 0; i <= last; ++i) {
      const int west = std::max(i - 1, 0), east = std::min(i + 1, last);
      const int south = std::max(j - 1, 0), north = std::min(j + 1, last);
      const double step_m = heights_m.step_m();
      map.at(i, j) =
          glm::vec2((heights_m.at(east, j) - heights_m.at(west, j)) / ((east - west) * step_m),
                    (heights_m.at(i, north) - heights_m.at(i, south)) / ((north - south) * step_m));
    }
  return map;
}

/// Of waves' heights, by soil that creeps as in crept().
double left_by_creep(double wave_m) {
  constexpr double length2_m2 = 0.1;
  const double turns_per_m = 2.0 * std::numbers::pi / wave_m;
  return math::exp(-turns_per_m * turns_per_m * length2_m2);
}

}  // namespace

FinerRelief::FinerRelief(const GroundMap<double>& heights_m, Roughness roughness, double hurst,
                         std::uint64_t seed)
    : hurst_(hurst), roughness_(std::move(roughness)), gradient_(gradients(heights_m)) {
  std::uint64_t index = 0;
  for (double wave_m = 2.0 * cell_m(heights_m); wave_m > min_wave_m; wave_m /= 2.0, ++index) {
    const auto bits = [&](const char* purpose) {
      return random_bits({seed, key_of("finer relief"), index, key_of(purpose)});
    };
    const auto unit = [&](const char* purpose) {
      return static_cast<double>(bits(purpose) >> 11) * 0x1.0p-53;
    };
    octaves_.push_back(
        {feature_of_waves * wave_m, bits("field"), glm::dvec2(unit("east"), unit("north"))});
  }
}

FinerRelief::Weights FinerRelief::shown_at(double step_m) const {
  constexpr double all = 0.3, none = 0.9;
  Weights weights;
  for (const Octave& octave : octaves_)
    weights.push_back(1.0 - glm::smoothstep(all, none, step_m / octave.feature_m));
  return weights;
}

FinerRelief::Weights FinerRelief::shown_below(double coarse_step_m, double step_m) const {
  const Weights coarse = shown_at(coarse_step_m);
  Weights weights = shown_at(step_m);
  for (std::size_t k = 0; k < weights.size(); ++k)
    weights[k] = std::max(weights[k] - coarse[k], 0.0) *
                 left_by_creep(octaves_[k].feature_m / feature_of_waves);
  return weights;
}

FinerRelief::Bump FinerRelief::at(const glm::dvec2& at_m, const Weights& weights) const {
  constexpr double carry = 0.65;  // features, at most
  Bump shown;
  double deviation_m = double{roughness_.deviation_m.sample(at_m.x, at_m.y)};
  double excess = double{roughness_.hurst.sample(at_m.x, at_m.y)} - hurst_;
  glm::dvec2 ascent(gradient_.sample(at_m.x, at_m.y));
  std::size_t last = weights.size();
  while (last > 0 && weights[last - 1] <= 0.0) --last;
  for (std::size_t k = 0; k < last; ++k) {
    const Octave& octave = octaves_[k];
    // Ground no steeper than the octave itself has no fall line for it.
    const double own_slope = 2.0 * deviation_m / octave.feature_m + 1e-9;
    const glm::dvec2 along = ascent * (carry / (glm::length(ascent) + own_slope));
    const NoiseSlope noise =
        carried_noise(at_m / octave.feature_m + octave.shift, along, octave.key);
    const glm::dvec2 gradient = noise.gradient * (deviation_m / octave.feature_m);
    ascent += gradient;
    shown.height_m += weights[k] * deviation_m * noise.value;
    shown.gradient += weights[k] * gradient;
    shown.deviation_m += weights[k] * weights[k] * deviation_m * deviation_m;
    excess *= 0.5;
    deviation_m *= math::exp2(-(hurst_ + excess));
  }
  shown.deviation_m = std::sqrt(shown.deviation_m);
  return shown;
}

}  // namespace wold::terrain
