#include "snow/wind_field.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/elementary.h"
#include "core/random.h"
#include "core/simd_turns.h"
#include "wind/gust_drift.h"

namespace wold::snow {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double own_deviation = 0.5;  ///< over the whole; of the variance a quarter
constexpr double shortest_common_m = 6.0, longest_common_m = 90.0;
constexpr std::array<double, 2> own_lengths_m = {1.5, 4.0};
constexpr std::array<double, 3> axis_fraction = {1.0, 1.0, 0.5};

/// The height of one of `waves` sines that together have a mean square of deviation^2.
double wave_height(double deviation, std::size_t waves) {
  return deviation * std::sqrt(2.0 / static_cast<double>(waves));
}

constexpr int bits_each = 10;  ///< three in each half of a flake's bits

float own_phase(std::uint32_t bits, int first_bit) {
  return static_cast<float>(static_cast<int>((bits >> first_bit) & 1023U)) * (1.0F / 1024.0F);
}

}  // namespace

WindField::WindField(const Weather& weather, double turbulence, std::uint64_t key,
                     std::shared_ptr<const wind::AirFlow> air)
    : weather_(weather),
      air_(std::move(air)),
      turbulence_(turbulence),
      own_heights_(wave_height(turbulence * own_deviation, own_lengths_m.size()) *
                   glm::dvec3(axis_fraction[0], axis_fraction[1], axis_fraction[2])) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t wave = 0; wave < common_waves; ++wave) {
      const double fraction = static_cast<double>(wave) / (common_waves - 1);
      common_[axis][wave] = {
          1.0 / (shortest_common_m * math::pow(longest_common_m / shortest_common_m, fraction)),
          random_uniform({key, key_of("gust"), wave, axis})};
    }
}

Motion WindField::common(double time_s, const glm::dvec2& place_m) const {
  const glm::dvec2 way = weather_.wind_way_m(time_s);
  const WeatherMoment now = weather_.at(time_s);
  const double heading = glm::radians(now.wind_heading_deg);
  Motion motion = {{way, 0.0},
                   now.wind_speed_m_s * glm::dvec3(math::sin(heading), math::cos(heading), 0.0)};
  const double run_m = weather_.wind_run_m(time_s);
  if (air_)
    add_gusts_of_air({now.wind_speed_m_s, now.wind_heading_deg, run_m}, place_m, motion);
  else
    add_own_common(run_m, now.wind_speed_m_s, motion);
  return motion;
}

void WindField::add_gusts_of_air(const wind::Moment& now, const glm::dvec2& place_m,
                                 Motion& motion) const {
  const wind::GustDrift drift =
      wind::gust_drift(air_->gusts(), place_m, wind::reference_m, shortest_common_m, now);
  motion.way_m += drift.way_m;
  motion.velocity_m_s += drift.velocity_m_s;
}

void WindField::add_own_common(double run_m, double speed_m_s, Motion& motion) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double height = wave_height(
        axis_fraction[axis] * turbulence_ * std::sqrt(1.0 - own_deviation * own_deviation),
        common_waves);
    for (const Wave& wave : common_[axis]) {
      const double phase = two_pi * off_whole(wave.per_m * run_m + wave.phase);
      const auto i = static_cast<glm::length_t>(axis);
      motion.way_m[i] += height / (two_pi * wave.per_m) * math::sin(phase);
      motion.velocity_m_s[i] += height * speed_m_s * math::cos(phase);
    }
  }
}

WindField::Moment WindField::moment(double time_s) const {
  const double run_m = weather_.wind_run_m(time_s);
  Moment moment = {{}, static_cast<float>(weather_.at(time_s).wind_speed_m_s)};
  for (std::size_t i = 0; i < own_lengths_m.size(); ++i)
    moment.phases[i] = static_cast<float>(off_whole(run_m / own_lengths_m[i]));
  return moment;
}

WindField::OwnWave WindField::own_wave(const Moment& moment, std::size_t wave) const {
  const std::size_t length = wave / 3;
  const float height = own_heights_[static_cast<glm::length_t>(wave % 3)];
  return {moment.phases[length], static_cast<float>(own_lengths_m[length] / two_pi) * height,
          moment.speed_m_s * height, length, bits_each * static_cast<int>(wave % 3)};
}

WindField::Gust WindField::own_gust(const Moment& moment, std::uint64_t bits) const {
  std::array<float, 2 * own_waves> waving;  // sines, then cosines: four at a time
  for (std::size_t i = 0; i < own_waves; ++i) {
    const OwnWave wave = own_wave(moment, i);
    waving[own_waves + i] =
        wave.phase +
        own_phase(static_cast<std::uint32_t>(bits >> (32 * wave.half)), wave.first_bit);
    waving[i] = waving[own_waves + i] - 0.25F;
  }
  for (float& value : waving) value = cosine_of_turns(value);
  Gust gust = {glm::vec3(0.0F), glm::vec3(0.0F)};
  for (std::size_t i = 0; i < own_waves; ++i) {
    const OwnWave wave = own_wave(moment, i);
    const auto axis = static_cast<glm::length_t>(i % 3);
    gust.way_m[axis] += wave.way_m * waving[i];
    gust.velocity_m_s[axis] += wave.velocity_m_s * waving[own_waves + i];
  }
  return gust;
}

WOLD_LANES_WIDE void WindField::add_own_gusts(const Moment& moment,
                                              const Lanes<std::uint64_t>& bits, VectorLanes& way_m,
                                              VectorLanes& velocity_m_s) const {
  const std::array ways_m = {&way_m.x, &way_m.y, &way_m.z};
  std::array<Lanes<std::uint32_t>, 2> halves;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    halves[0][lane] = static_cast<std::uint32_t>(bits[lane]);
    halves[1][lane] = static_cast<std::uint32_t>(bits[lane] >> 32);
  }
  const std::array velocities_m_s = {&velocity_m_s.x, &velocity_m_s.y, &velocity_m_s.z};
  for (std::size_t i = 0; i < own_waves; ++i) {
    const OwnWave wave = own_wave(moment, i);
    const Lanes<std::uint32_t>& half = halves[wave.half];
    Lanes<float>& along_m = *ways_m[i % 3];
    Lanes<float>& along_m_s = *velocities_m_s[i % 3];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const float turns = wave.phase + own_phase(half[lane], wave.first_bit);
      along_m[lane] += wave.way_m * sine_of_turns(turns);
      along_m_s[lane] += wave.velocity_m_s * cosine_of_turns(turns);
    }
  }
}

double WindField::farthest_own_gust_m() const {
  double sum_m = 0.0;
  for (const double length_m : own_lengths_m) sum_m += length_m / two_pi;
  return sum_m * static_cast<double>(glm::length(own_heights_));
}

}  // namespace wold::snow
