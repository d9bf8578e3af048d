#include "terrain/roughness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/statistics.h"

namespace wold::terrain {
namespace {

/// Value of each sample from its neighbours `stride` steps away, along one axis; beyond the border
/// the border's.
template <class Map>
Map filtered_along(const Map& map, const glm::ivec2& stride) {
  Map result = map;
  const auto inside = [&](int i) { return std::clamp(i, 0, map.samples() - 1); };
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < map.samples(); ++i)
      result.at(i, j) = map.at(i, j) / 2 + map.at(inside(i - stride.x), inside(j - stride.y)) / 4 +
                        map.at(inside(i + stride.x), inside(j + stride.y)) / 4;
  });
  return result;
}

template <class Map>
Map filtered(const Map& map, int stride) {
  return filtered_along(filtered_along(map, {stride, 0}), {0, stride});
}

constexpr int steps_per_cell = 2;

/// Mean of the squares of a difference of two maps, smoothed `passes` times over a cell.
FactorMap local_power(const GroundMap<double>& a, const GroundMap<double>& b, int passes) {
  FactorMap power(a.samples(), a.square());
  for (std::size_t k = 0; k < power.values().size(); ++k) {
    const double difference = a.values()[k] - b.values()[k];
    power.values()[k] = static_cast<float>(difference * difference);
  }
  for (int pass = 0; pass < passes; ++pass) power = filtered(power, steps_per_cell);
  return filtered(power, 1);
}

/// Of a wave's height, by cubic convolution (Keys 1981); `frequency` in turns per cell, more than
/// 0.
double kept_by_convolution(double frequency) {
  const double turns = std::numbers::pi * frequency;
  const auto sinc = [turns](double times) { return math::sin(times * turns) / (times * turns); };
  return (3.0 * (sinc(1.0) * sinc(1.0) - sinc(2.0)) -
          (3.0 * sinc(2.0) * sinc(2.0) - 2.0 * sinc(2.0) - sinc(4.0))) /
         (turns * turns);
}

/// What the two filters see of ground whose power falls with frequency^-p, turns per cell.
class FilterResponse {
 public:
  explicit FilterResponse(Held held) {
    for (std::size_t k = 0; k < count; ++k) add(k, held);
  }

  /// p, from log2 of the coarse difference's power over the fine one's.
  double exponent(double log2_ratio) const {
    const auto above =
        std::upper_bound(log2_ratios_.begin() + 1, log2_ratios_.end() - 1, log2_ratio);
    const auto k = static_cast<std::size_t>(above - log2_ratios_.begin());
    const double t = (log2_ratio - log2_ratios_[k - 1]) / (log2_ratios_[k] - log2_ratios_[k - 1]);
    return exponent_of(k - 1) + step * std::clamp(t, 0.0, 1.0);
  }

  /// Power of the finest octave that cells hold, waves of two to four, over that of the fine
  /// difference.
  double octave_over_fine(double exponent) const {
    const double place = std::clamp((exponent - least) / step, 0.0, count - 1.001);
    const auto k = static_cast<std::size_t>(place);
    return std::lerp(octaves_[k], octaves_[k + 1], place - static_cast<double>(k));
  }

 private:
  static constexpr std::size_t count = 29;
  static constexpr double least = 1.0, step = 0.25;
  static double exponent_of(std::size_t k) { return least + step * static_cast<double>(k); }

  /// Integrals over frequencies up to half a turn per step.
  void add(std::size_t k, Held held) {
    constexpr int parts = 64;
    double fine = 0.0, coarse = 0.0, octave = 0.0;
    for (int j = 0; j < parts; ++j)
      for (int i = 0; i < parts; ++i) {
        const glm::dvec2 frequency = (glm::dvec2(i, j) + 0.5) / (1.0 * parts);
        const double power = power_at(frequency, -exponent_of(k), held);
        const double first = kept(frequency), second = kept(2.0 * frequency);
        fine += power * (1.0 - first) * (1.0 - first);
        coarse += power * first * first * (1.0 - second) * (1.0 - second);
        const double length = glm::length(frequency);
        if (length >= 0.25 && length < 0.5) octave += math::pow(length, -exponent_of(k));
      }
    log2_ratios_[k] = math::log2(coarse / fine);
    octaves_[k] = octave / fine;
  }

  /// Between cells the power of what they hold comes again, as far as interpolation lets it.
  static double power_at(const glm::dvec2& frequency, double exponent, Held held) {
    if (held == Held::exactly) return math::pow(glm::length(frequency), exponent);
    const glm::dvec2 in_cells = glm::min(frequency, 1.0 - frequency);
    const double kept = kept_by_convolution(frequency.x) * kept_by_convolution(frequency.y);
    return math::pow(glm::length(in_cells), exponent) * kept * kept;
  }

  /// Of a wave's height, by 1 2 1 along both axes.
  static double kept(const glm::dvec2& frequency) {
    constexpr double turn = 2.0 * std::numbers::pi;
    return 0.25 * (1.0 + math::cos(turn * frequency.x)) * (1.0 + math::cos(turn * frequency.y));
  }

  std::array<double, count> log2_ratios_{}, octaves_{};
};

constexpr float least_power_m2 = 1e-8F;

}  // namespace

Roughness measured_roughness(const GroundMap<double>& heights_m, Held held) {
  constexpr int near = 2, around = 9;
  constexpr double of_place = 0.4, steeper = 1.0, min_exponent = 3.5, max_exponent = 7.0;
  const GroundMap<double> once = filtered(heights_m, steps_per_cell);
  const GroundMap<double> twice = filtered(once, 2 * steps_per_cell);
  const FactorMap fine_near = local_power(heights_m, once, near);
  const FactorMap fine = local_power(heights_m, once, around);
  const FactorMap coarse = local_power(once, twice, around);
  const FilterResponse response(held);
  const auto exponent = [&](double fine_m2, double coarse_m2) {
    return response.exponent(math::log2((coarse_m2 + least_power_m2) / (fine_m2 + least_power_m2)));
  };
  const double of_map = exponent(mean(fine.values()), mean(coarse.values()));
  Roughness roughness{FactorMap(heights_m.samples(), heights_m.square()),
                      FactorMap(heights_m.samples(), heights_m.square())};
  parallel_for_blocks(fine.values().size(), [&](std::size_t k) {
    const double p = std::lerp(of_map, exponent(fine.values()[k], coarse.values()[k]), of_place);
    const double hurst = 0.5 * std::clamp(p + steeper, min_exponent, max_exponent) - 1.0;
    const double finest_m2 = response.octave_over_fine(p) * fine_near.values()[k];
    roughness.deviation_m.values()[k] =
        static_cast<float>(std::sqrt(finest_m2) * math::exp2(-hurst));
    roughness.hurst.values()[k] = static_cast<float>(hurst);
  });
  return roughness;
}

}  // namespace wold::terrain
