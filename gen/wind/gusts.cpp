#include "wind/gusts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/random.h"

namespace wold::wind {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr int bands = 48;
constexpr int modes_per_band = 4;
constexpr double longest_m = 2000.0, shortest_m = 0.5;
constexpr double davenport_decay = 10.0;

/// The k-th border between bands, 0 to `bands`.
double border_per_m(int k) {
  return math::pow(longest_m / shortest_m, static_cast<double>(k) / bands) / longest_m;
}

/// How far from 0 a point of the plane lies, in scales, that has a Cauchy distribution: 1 in `u` of
/// them is farther than this. (1 + r^2)^(-1/2) of them are.
double cauchy_radius(double u) { return std::sqrt(1.0 / (u * u) - 1.0); }

}  // namespace

Gusts::Gusts(const Profile& profile, double intensity, std::uint64_t seed)
    : profile_(profile), intensity_(intensity) {
  for (int i = 0; i < bands * modes_per_band; ++i) {
    const auto uniform = [&](const char* purpose) {
      return random_uniform({seed, key_of("gust"), static_cast<std::uint64_t>(i), key_of(purpose)});
    };
    const double low = border_per_m(i / modes_per_band),
                 high = border_per_m(i / modes_per_band + 1);
    const double along = low * math::pow(high / low, uniform("wave length"));
    const double square = davenport_decay / two_pi * along * cauchy_radius(1.0 - uniform("aside"));
    const double angle = two_pi * uniform("way aside");
    modes_.push_back({i < modes_per_band ? 0.0 : low,
                      high,
                      along,
                      square * math::cos(angle),
                      square * math::sin(angle),
                      {uniform("along"), uniform("across"), uniform("up")}});
  }
}

std::vector<GustWave> Gusts::waves(double height_m, const Moment& now) const {
  const Axes axes(now.heading_deg);
  // From waves per metre to Kaimal's f, frequencies being those at reference_m's speed.
  const double f_m = profile_.above_displacement_m(height_m) /
                     profile_.at(std::max(height_m, profile_.canopy_m()));
  std::vector<GustWave> waves;
  waves.reserve(modes_.size());
  for (const Mode& mode : modes_) {
    GustWave wave{axes.on_ground({mode.along_per_m, mode.right_per_m}),
                  mode.along_per_m * now.speed_m_s,
                  {},
                  {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto component = static_cast<Component>(i);
      const double variance = (variance_below(component, mode.high_per_m * f_m) -
                               variance_below(component, mode.low_per_m * f_m)) /
                              modes_per_band;
      wave.height[i] = intensity_ * std::sqrt(2.0 * variance);
      wave.phase[i] = mode.phase[i] + mode.up_per_m * height_m - mode.along_per_m * now.run_m;
    }
    waves.push_back(wave);
  }
  return waves;
}

glm::dvec3 gust_at(const std::vector<GustWave>& waves, const glm::dvec2& place_m) {
  glm::dvec3 sum(0.0);
  for (const GustWave& wave : waves)
    for (std::size_t i = 0; i < 3; ++i)
      sum[static_cast<glm::length_t>(i)] +=
          wave.height[i] * math::cos(two_pi * (glm::dot(wave.per_m, place_m) + wave.phase[i]));
  return sum;
}

}  // namespace wold::wind
