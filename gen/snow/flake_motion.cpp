#include "snow/flake_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/random.h"
#include "core/simd_turns.h"

namespace wold::snow {
namespace {

/// They sway at 2 to 5 rad/s (Li 2024).
constexpr float min_sway = 0.15F;  ///< of the widest of their size
constexpr double turns_per_rad = 0.5 / std::numbers::pi;
constexpr double slowest_sway_per_s = 2.0 * turns_per_rad, sway_range_per_s = 3.0 * turns_per_rad;

/// They tumble at 0.5 to 2.5 turns a second (Li 2024: 1 to 3 for aggregates), and turn either way
/// about the way to the eye at up to half of that.
constexpr double slowest_tilt_per_s = 0.5, tilt_range_per_s = 2.0, fastest_spin_per_s = 1.25;

/// So few rates that 2^rate_bits times the rounding of a step is nothing.
constexpr int rate_bits = 7;
constexpr double rates = 1 << rate_bits;

/// Some of the random bits, as a whole number.
float field_of(std::uint64_t bits, int first, int count) {
  return static_cast<float>(static_cast<int>((bits >> first) & ((1U << count) - 1U)));
}

FlakeMotion::Turning turning(double slowest_per_s, double range_per_s, double time_s) {
  return {static_cast<float>(off_whole(slowest_per_s * time_s)),
          static_cast<float>(off_whole(range_per_s / rates * time_s))};
}

/// Where a turning is whose rate and start are 7 and 10 random bits.
float turned(const FlakeMotion::Turning& turning, std::uint64_t bits, int first) {
  return turning.slowest + turning.step * field_of(bits, first, rate_bits) +
         field_of(bits, first + rate_bits, 10) * (1.0F / 1024.0F);
}

constexpr int sway_bits = 0, tilt_bits = 17, spin_bits = 34, lean_bits = 51;

/// Twenty-one random bits as a turn.
std::uint32_t third_of(std::uint64_t bits, int place) {
  return static_cast<std::uint32_t>(bits >> (21 * place)) << 11;
}

/// Where in the cube that turn of a column is, of which 2^bits lie beside each other.
std::uint32_t start_turn(std::uint64_t column, std::uint32_t in_column, int bits) {
  return static_cast<std::uint32_t>((column << 32 | in_column) >> bits);
}

}  // namespace

Population::Population(std::uint64_t key, std::uint64_t flakes, int max_bits)
    : key_(key), flakes_(flakes) {
  constexpr std::uint64_t min_in_column = 64;
  while (bits_ < max_bits && flakes >> (2 * (bits_ + 1)) >= min_in_column) ++bits_;
  const std::uint64_t columns = std::uint64_t{1} << (2 * bits_);
  columns_per_flake_ =
      std::max<std::uint64_t>(1, (columns << 32) / std::max<std::uint64_t>(1, flakes));
}

FlakeMotion::FlakeMotion(const scene::PrecipitationPart& part, const Weather& weather,
                         double rate_mm_h, Falling what, std::shared_ptr<const wind::AirFlow> air)
    : what_(what),
      wind_(weather, part.wind.field == scene::WindPattern::steady ? 0.0 : part.wind.turbulence,
            random_bits({part.seed, key_of("snow"), 0, key_of("wind")}), std::move(air)),
      sizes_(what == Falling::rain ? FlakeSizes::raindrops(rate_mm_h)
                                   : FlakeSizes(rate_mm_h, part.snowfall.crystal)),
      farthest_gust_m_(static_cast<float>(wind_.farthest_own_gust_m())) {}

FlakeMotion::Moment FlakeMotion::moment(double time_s, double rate_mm_h,
                                        const glm::dvec2& eye_m) const {
  return {time_s,
          sizes_.diameters_m(rate_mm_h),
          wind_.common(time_s, eye_m),
          wind_.moment(time_s),
          turning(slowest_sway_per_s, sway_range_per_s, time_s),
          turning(-fastest_spin_per_s, 2.0 * fastest_spin_per_s, time_s),
          turning(slowest_tilt_per_s, tilt_range_per_s, time_s),
          static_cast<float>(sizes_.thinning_per_m(rate_mm_h))};
}

FlakeMotion::Air FlakeMotion::air(const Population& population, const PeriodicCube& cube,
                                  const Moment& moment, const glm::dvec3& eye_m) {
  const glm::dvec3 way = (moment.common.way_m - cube.centre_m) / cube.side_m;
  return {
      population,
      {turn_of(way.x), turn_of(way.y), turn_of(way.z)},
      fraction_of(moment.time_s * static_cast<double>(FlakeSizes::speed_unit_m_s) / cube.side_m),
      glm::vec3(cube.centre_m - eye_m),
      static_cast<float>(cube.side_m)};
}

void FlakeMotion::Drifting::set(std::size_t lane, const Drifting& other, std::size_t others_lane) {
  from_eye.set(lane, other.from_eye.at(others_lane));
  key[lane] = other.key[others_lane];
  speed[lane] = other.speed[others_lane];
}

WOLD_LANES_WIDE void FlakeMotion::drift(const Air& air, std::uint64_t first,
                                        Drifting& flakes) const {
  const Air by = air;
  const std::uint64_t population_key = by.population.key();
  const int bits = by.population.bits();
  Lanes<std::uint64_t> starts;
  for (std::size_t i = 0; i < lanes; ++i) {
    flakes.key[i] = mixed(population_key ^ (first + i));
    starts[i] = mixed(flakes.key[i] ^ key_of("start"));
  }
  Lanes<std::uint32_t> fallen, column;
  for (std::size_t i = 0; i < lanes; ++i) {
    const std::uint32_t speed = sizes_.speed(flakes.key[i]);
    flakes.speed[i] = static_cast<std::int32_t>(speed);
    fallen[i] = static_cast<std::uint32_t>((speed * by.fall) >> 32);
    column[i] = by.population.column_of(first + i);
  }
  const float turn_m = by.side_m * 0x1p-32F;
  const auto metres = [&](std::uint32_t turn) {
    return turn_m * static_cast<float>(static_cast<std::int32_t>(turn));
  };
  for (std::size_t i = 0; i < lanes; ++i) {
    const std::uint32_t x = start_turn(column[i], third_of(starts[i], 0), bits);
    const std::uint32_t y = start_turn(column[i] >> bits, third_of(starts[i], 1), bits);
    const std::uint32_t z = third_of(starts[i], 2);
    flakes.from_eye.x[i] = by.centre_from_eye_m.x + metres(x + by.way.x);
    flakes.from_eye.y[i] = by.centre_from_eye_m.y + metres(y + by.way.y);
    flakes.from_eye.z[i] = by.centre_from_eye_m.z + metres(z + by.way.z - fallen[i]);
  }
}

WOLD_LANES_WIDE void FlakeMotion::fly(const Drifting& drifting, const Moment& moment,
                                      FlakeLanes& flakes) const {
  Lanes<std::uint64_t> gusts;
  for (std::size_t i = 0; i < lanes; ++i) {
    gusts[i] = mixed(drifting.key[i] ^ key_of("gust"));
    flakes.bits[i] = mixed(drifting.key[i] ^ key_of("look"));
  }
  for (std::size_t i = 0; i < lanes; ++i) {
    const std::uint32_t rank = FlakeSizes::rank(drifting.key[i]);
    flakes.diameter[i] = moment.diameters_m[rank];
    flakes.crystal[i] = sizes_.crystal(rank);
  }
  const glm::vec3 common_m_s(moment.common.velocity_m_s);
  for (std::size_t i = 0; i < lanes; ++i) {
    flakes.velocity.x[i] = common_m_s.x;
    flakes.velocity.y[i] = common_m_s.y;
    flakes.velocity.z[i] =
        common_m_s.z - FlakeSizes::speed_unit_m_s * static_cast<float>(drifting.speed[i]);
    flakes.opacity[i] = 1.0F;
    flakes.tilt_turns[i] = turned(moment.tilt, flakes.bits[i], tilt_bits);
    flakes.spin_turns[i] = turned(moment.spin, flakes.bits[i], spin_bits);
  }
  flakes.from_eye = drifting.from_eye;
  wind_.add_own_gusts(moment.gusts, gusts, flakes.from_eye, flakes.velocity);
  if (what_ == Falling::snow) add_sway(moment, flakes);
}

WOLD_LANES_WIDE void FlakeMotion::add_sway(const Moment& moment, FlakeLanes& flakes) {
  for (std::size_t i = 0; i < lanes; ++i) {
    const std::uint64_t bits = flakes.bits[i];
    const float wide = field_of(bits, lean_bits, 10) * (1.0F / 1024.0F);
    const float height_m =
        widest_sway_of_m(flakes.diameter[i]) * (min_sway + (1.0F - min_sway) * wide);
    constexpr auto slowest_rad_s = static_cast<float>(slowest_sway_per_s / turns_per_rad);
    constexpr auto step_rad_s = static_cast<float>(sway_range_per_s / turns_per_rad / rates);
    const float speed_m_s =
        height_m * (slowest_rad_s + step_rad_s * field_of(bits, sway_bits, rate_bits));
    const float phase = turned(moment.sway, bits, sway_bits);
    const float across = phase + 0.7F * wide;  // leans either way
    flakes.from_eye.x[i] += height_m * sine_of_turns(phase);
    flakes.from_eye.y[i] += height_m * sine_of_turns(across);
    flakes.velocity.x[i] += speed_m_s * cosine_of_turns(phase);
    flakes.velocity.y[i] += speed_m_s * cosine_of_turns(across);
  }
}

double FlakeMotion::farthest_own_way_m() const {
  const float sway_m = what_ == Falling::rain ? 0.0F : farthest_sway_m(full_sway_m);
  return static_cast<double>(farthest_gust_m_ + sway_m);
}

}  // namespace wold::snow
