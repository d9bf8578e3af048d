#include "snow/snow_line.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "core/normal_distribution.h"
#include "core/parallel.h"
#include "core/random.h"
#include "snow/hollows.h"

namespace wold::snow {
namespace {

constexpr double largest_m = 100.0, hurst = 0.0;
/// Of hollows, over the noise's deviation.
constexpr double drawn_to_hollows = 0.35;

}  // namespace

SnowLine::SnowLine(const Heightfield& terrain, double smallest_m, std::uint64_t seed)
    : smallest_m_(std::min(smallest_m, largest_m)),
      key_(random_bits({seed, key_of("snow cover"), 0, key_of("snow line")})),
      hollows_(hollows(terrain, terrain.step_m())) {}

/// Snow lies where a normal variable is below the fraction's quantile. A map's steps show a part of
/// it; the rest is normal, too, and its distribution tells how much of the place is white.
FactorMap SnowLine::white_map(const FactorMap& fractions) const {
  constexpr double none = 1e-4, sharpest = 0.05;
  const ScaleFreeNoise noise(key_, {largest_m, smallest_m_}, hurst, fractions.step_m());
  const double not_shown = std::max(std::sqrt(std::max(1.0 - noise.shown(), 0.0)), sharpest);
  const double deviation =
      std::sqrt(noise.shown() + not_shown * not_shown + drawn_to_hollows * drawn_to_hollows);
  FactorMap white = fractions;
  parallel_for(static_cast<std::size_t>(white.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < white.samples(); ++i) {
      const double fraction{fractions.at(i, j)};
      if (fraction < none || fraction > 1.0 - none) continue;
      const glm::dvec2 at_m = white.place_m(i, j);
      const double late =
          noise.at(at_m) - drawn_to_hollows * double{hollows_.sample(at_m.x, at_m.y)};
      white.at(i, j) = static_cast<float>(
          normal_cdf((deviation * normal_quantile(fraction) - late) / not_shown));
    }
  });
  return white;
}

}  // namespace wold::snow
