#include "snow/wind_field.h"

#include <cmath>
#include <numbers>

#include "core/random.h"
#include "snow/turns.h"

namespace wold::snow {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double own_share = 0.25;  ///< of the variance
constexpr double shortest_common_m = 6.0, longest_common_m = 90.0;
constexpr std::array<double, 2> own_lengths_m = {1.5, 4.0};
constexpr std::array<double, 3> axis_share = {1.0, 1.0, 0.5};

/// The height of one of `waves` sines that together have a mean square of deviation^2.
double wave_height(double deviation, std::size_t waves) {
  return deviation * std::sqrt(2.0 / static_cast<double>(waves));
}

}  // namespace

WindField::WindField(const Weather& weather, double turbulence, std::uint64_t key)
    : weather_(weather), turbulence_(turbulence) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t wave = 0; wave < common_waves; ++wave) {
      const double share = static_cast<double>(wave) / (common_waves - 1);
      common_[axis][wave] = {
          1.0 / (shortest_common_m * std::pow(longest_common_m / shortest_common_m, share)),
          random_uniform({key, key_of("gust"), wave, axis})};
    }
}

Motion WindField::common(double time_s) const {
  const glm::dvec2 way = weather_.wind_way_m(time_s);
  const WeatherMoment now = weather_.at(time_s);
  const double heading = glm::radians(now.wind_heading_deg);
  Motion motion = {{way, 0.0},
                   now.wind_speed_m_s * glm::dvec3(std::sin(heading), std::cos(heading), 0.0)};
  const double run_m = weather_.wind_run_m(time_s);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double height =
        wave_height(axis_share[axis] * turbulence_ * std::sqrt(1.0 - own_share), common_waves);
    for (const Wave& wave : common_[axis]) {
      const double phase = two_pi * fraction(wave.per_m * run_m + wave.phase);
      const auto i = static_cast<glm::length_t>(axis);
      motion.way_m[i] += height / (two_pi * wave.per_m) * std::sin(phase);
      motion.velocity_m_s[i] += height * now.wind_speed_m_s * std::cos(phase);
    }
  }
  return motion;
}

WindField::Moment WindField::moment(double time_s) const {
  return {weather_.wind_run_m(time_s), weather_.at(time_s).wind_speed_m_s};
}

Motion WindField::own_gust(const Moment& moment, std::uint64_t bits) const {
  Motion motion;
  const double height = wave_height(turbulence_ * std::sqrt(own_share), own_lengths_m.size());
  for (const double length_m : own_lengths_m)
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      constexpr std::uint64_t bits_each = 10;
      const double phase = moment.run_m / length_m + static_cast<double>(bits & 1023U) / 1024.0;
      bits >>= bits_each;
      const double along = height * axis_share[static_cast<std::size_t>(axis)];
      motion.way_m[axis] += along * length_m / two_pi * static_cast<double>(sine_of_turns(phase));
      motion.velocity_m_s[axis] +=
          along * moment.speed_m_s * static_cast<double>(cosine_of_turns(phase));
    }
  return motion;
}

double WindField::farthest_own_gust_m() const {
  const double height = wave_height(turbulence_ * std::sqrt(own_share), own_lengths_m.size());
  double sum_m = 0.0;
  for (const double length_m : own_lengths_m) sum_m += height * length_m / two_pi;
  constexpr double longest_diagonal = 1.5;  // of the axes' shares: sqrt(1 + 1 + 1/4)
  return longest_diagonal * sum_m;
}

}  // namespace wold::snow
