#include "snow/whitening.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/elementary.h"
#include "core/noise.h"
#include "core/random.h"
#include "snow/hollows.h"

namespace wold::snow {
namespace {

/// Octaves of the noise, from patches to two steps of the map.
Fbm patch_noise(double step_m, double feature_m, std::uint64_t seed) {
  constexpr double max_octaves = 6.0;
  const double octaves = std::floor(math::log2(std::max(feature_m / (2.0 * step_m), 1.0))) + 1.0;
  return Fbm(random_bits({seed, key_of("snow cover"), 0, key_of("patches")}),
             static_cast<int>(std::min(octaves, max_octaves)), /*hurst=*/0.7);
}

/// The fraction of all values that are lower, by counts in small intervals.
class Ranks {
 public:
  explicit Ranks(const std::vector<float>& values) : below_(intervals + 1, 0.0) {
    for (float value : values) below_[interval(value) + 1] += 1.0 / values.size();
    std::partial_sum(below_.begin(), below_.end(), below_.begin());
  }
  double of(float value) const {
    const std::size_t i = interval(value);
    return std::lerp(below_[i], below_[i + 1], place(value) - static_cast<double>(i));
  }

 private:
  static constexpr std::size_t intervals = 16384;
  static constexpr double farthest = 8.0;  ///< deviations from the mean
  static double place(float value) {
    return std::clamp((value / farthest + 1.0) * 0.5, 0.0, 1.0) * intervals;
  }
  static std::size_t interval(float value) {
    return std::min(static_cast<std::size_t>(place(value)), intervals - 1);
  }
  std::vector<double> below_;
};

}  // namespace

double cover_fraction(double water_mm) {
  constexpr double fresh_kg_m3 = 100.0, scale_m = 2.5 * 0.01;
  return math::tanh(water_mm / fresh_kg_m3 / scale_m);
}

double white(double rank, double threshold, double ramp) {
  return std::clamp((threshold - rank) / ramp + 0.5, 0.0, 1.0);
}

double threshold(double fraction, double ramp) {
  // At low shares only part of the ramp reaches into [0, 1]: share = (t + ramp/2)^2 / (2 ramp), as
  // long as neither its middle part nor all ranks are in it.
  const double corner = std::min(0.5 * ramp, 0.5 / ramp);
  if (fraction < corner) return std::sqrt(2.0 * ramp * fraction) - 0.5 * ramp;
  if (fraction > 1.0 - corner) return 1.0 + 0.5 * ramp - std::sqrt(2.0 * ramp * (1.0 - fraction));
  return ramp < 1.0 ? fraction : 0.5 + (fraction - 0.5) * ramp;
}

WhitePatches::WhitePatches(const Heightfield& terrain, int samples, double feature_m,
                           std::uint64_t seed)
    : WhitePatches(terrain, {{.size_m = terrain.size_m()}, samples}, feature_m, seed) {}

WhitePatches::WhitePatches(const Heightfield& terrain, const GroundGrid& grid, double feature_m,
                           std::uint64_t seed)
    : ranks_(grid.samples, grid.square) {
  constexpr double drawn_to_hollows = 0.35;
  const FactorMap hollow = hollows(terrain, feature_m);
  const Fbm noise = patch_noise(ranks_.step_m(), feature_m, seed);
  const auto late = [&](const glm::dvec2& at_m) {  // about mean 0, deviation 1
    return static_cast<float>(noise.at(at_m / feature_m) -
                              drawn_to_hollows * hollow.sample(at_m.x, at_m.y));
  };
  std::vector<float>& values = ranks_.values();
  const auto side = static_cast<std::size_t>(grid.samples);
  const auto at_m = [&](std::size_t i) {
    return ranks_.place_m(static_cast<int>(i % side), static_cast<int>(i / side));
  };
  parallel_for_blocks(values.size(), [&](std::size_t i) { values[i] = late(at_m(i)); });
  const Ranks ranks(values);

  // The ramp: how much ranks change in a step, from the slope at keyed places.
  constexpr std::uint64_t looks = 4096;
  const double near_m = std::min(ranks_.step_m(), feature_m / 16.0);
  double change = 0.0;
  for (std::uint64_t look = 0; look < looks; ++look) {
    const RandomKey key{seed, key_of("snow cover"), look, key_of("ramp")};
    const glm::dvec2 place_m = at_m(random_bits(key) % values.size());
    change += std::abs(ranks.of(late(place_m)) - ranks.of(late(place_m + glm::dvec2(near_m, 0.0))));
  }
  ramp_ = std::max(change / looks * ranks_.step_m() / near_m, 1e-6);
  parallel_for_blocks(values.size(),
                      [&](std::size_t i) { values[i] = static_cast<float>(ranks.of(values[i])); });
}

FactorMap WhitePatches::white_map(const FactorMap& fractions) const {
  FactorMap result(ranks_.samples(), ranks_.square());
  parallel_for(static_cast<std::size_t>(ranks_.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < ranks_.samples(); ++i) {
      const glm::dvec2 at_m = ranks_.place_m(i, j);
      const double fraction = fractions.sample(at_m.x, at_m.y);
      result.at(i, j) =
          static_cast<float>(white(ranks_.at(i, j), threshold(fraction, ramp_), ramp_));
    }
  });
  return result;
}

}  // namespace wold::snow
