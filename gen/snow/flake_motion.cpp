#include "snow/flake_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "snow/size_distribution.h"
#include "snow/turns.h"

namespace wold::snow {
namespace {

/// Aggregates of a centimetre sway by 3 to 20 cm at 2 to 5 rad/s (Li 2024), small flakes by less.
constexpr double least_sway = 0.15, farthest_sway_m = 0.2, sways_most_m = 0.01;
constexpr double slowest_sway_rad_s = 2.0, fastest_sway_rad_s = 5.0;

/// They tumble at 0.5 to 2.5 turns a second (Li 2024: 1 to 3 for aggregates).
constexpr double slowest_turn_per_s = 0.5, turn_range_per_s = 2.0;

/// Twenty-one random bits as a number in [0, 1).
double third_of(std::uint64_t bits, int place) {
  return static_cast<double>(static_cast<int>((bits >> (21 * place)) & 0x1fffffU)) * 0x1.0p-21;
}

WindField::Gust sway(double diameter_m, double time_s, std::uint64_t bits) {
  const double wide = least_sway + (1.0 - least_sway) * third_of(bits, 0);
  const double height_m = farthest_sway_m * wide * std::min(1.0, diameter_m * (1.0 / sways_most_m));
  const double rad_s =
      slowest_sway_rad_s + (fastest_sway_rad_s - slowest_sway_rad_s) * third_of(bits, 1);
  constexpr double turns_per_rad = 0.5 / std::numbers::pi;
  const auto phase =
      static_cast<float>(off_whole(turns_per_rad * rad_s * time_s + third_of(bits, 2)));
  const float across = phase + 0.7F * static_cast<float>(third_of(bits, 0));  // leans either way
  const auto waving = sines_and_cosines(std::array<float, 2>{phase, across});
  return {static_cast<float>(height_m) * glm::vec3(waving[0], waving[1], 0.0F),
          static_cast<float>(height_m * rad_s) * glm::vec3(waving[2], waving[3], 0.0F)};
}

}  // namespace

FlakeMotion::FlakeMotion(const scene::Scene& scene, const Weather& weather, double rate_mm_h)
    : wind_(weather, scene.wind.field == "steady" ? 0.0 : scene.wind.turbulence,
            random_bits({scene.seed, key_of("snow"), 0, key_of("wind")})),
      sizes_(rate_mm_h, scene.snowfall.crystal) {}

FlakeMotion::Moment FlakeMotion::moment(double time_s, double rate_mm_h) const {
  return {time_s, sizes_.diameters_m(gunn_marshall(rate_mm_h).lambda_per_mm), wind_.common(time_s),
          wind_.moment(time_s)};
}

FlakeMotion::Drifting FlakeMotion::drifting(std::uint64_t population_key, std::uint64_t index,
                                            const Moment& moment, const PeriodicCube& cube) const {
  const std::uint64_t key = mixed(population_key ^ index);
  const std::uint64_t start = mixed(key ^ key_of("start"));
  const FlakeSizes::Body body = sizes_.body(key);
  const glm::dvec3 fall_m(0.0, 0.0, body.speed_m_s * moment.time_s);
  const glm::dvec3 sides = (moment.common.way_m - fall_m - cube.centre_m) * (1.0 / cube.side_m) +
                           glm::dvec3(third_of(start, 0), third_of(start, 1), third_of(start, 2));
  const glm::dvec3 place_m =
      cube.centre_m +
      cube.side_m * glm::dvec3(off_whole(sides.x), off_whole(sides.y), off_whole(sides.z));
  return {place_m, body, key};
}

Flake FlakeMotion::flake(const Drifting& drifting, const Moment& moment) const {
  const auto diameter_m = static_cast<double>(moment.diameters_m[drifting.body.rank]);
  const auto gust = wind_.own_gust(moment.gusts, mixed(drifting.key ^ key_of("gust")));
  const auto swaying = sway(diameter_m, moment.time_s, mixed(drifting.key ^ key_of("sway")));
  const std::uint64_t look = mixed(drifting.key ^ key_of("look"));
  const double turns_per_s = slowest_turn_per_s + turn_range_per_s * third_of(look, 2);
  const double spins_per_s = (third_of(look, 1) - 0.5) * turns_per_s;
  const auto turned = [&](double per_s, double start) {
    return static_cast<float>(off_whole(per_s * moment.time_s + start));
  };
  const glm::dvec3 fall_m_s(0.0, 0.0, -drifting.body.speed_m_s);
  return {
      drifting.place_m + glm::dvec3(gust.way_m + swaying.way_m),
      moment.common.velocity_m_s + fall_m_s + glm::dvec3(gust.velocity_m_s + swaying.velocity_m_s),
      diameter_m,
      drifting.body.crystal,
      look,
      turned(spins_per_s, third_of(look, 1)),
      turned(turns_per_s, third_of(look, 0))};
}

double FlakeMotion::farthest_own_way_m() const {
  constexpr double diagonal = 1.4142136;
  return wind_.farthest_own_gust_m() + diagonal * farthest_sway_m;
}

}  // namespace wold::snow
