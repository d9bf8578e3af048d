#include "snow/flake_motion.h"

#include <algorithm>
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

/// Twenty-one random bits as a number in [0, 1).
double third_of(std::uint64_t bits, int place) {
  return static_cast<double>((bits >> (21 * place)) & 0x1fffffU) * 0x1.0p-21;
}

Motion sway(double diameter_m, double time_s, std::uint64_t bits) {
  const double wide = least_sway + (1.0 - least_sway) * third_of(bits, 0);
  const double height_m = farthest_sway_m * wide * std::min(1.0, diameter_m / sways_most_m);
  const double rad_s =
      slowest_sway_rad_s + (fastest_sway_rad_s - slowest_sway_rad_s) * third_of(bits, 1);
  const double phase = rad_s * time_s / (2.0 * std::numbers::pi) + third_of(bits, 2);
  // An ellipse that leans either way.
  const double across_phase = phase + 0.7 * third_of(bits, 0);
  const double rate = height_m * rad_s;
  return {height_m * glm::dvec3(sine_of_turns(phase), sine_of_turns(across_phase), 0.0F),
          rate * glm::dvec3(cosine_of_turns(phase), cosine_of_turns(across_phase), 0.0F)};
}

}  // namespace

FlakeMotion::FlakeMotion(const scene::Scene& scene, const Weather& weather, double rate_mm_h)
    : wind_(weather, scene.wind.field == "steady" ? 0.0 : scene.wind.turbulence,
            random_bits({scene.seed, key_of("snow"), 0, key_of("wind")})),
      sizes_(rate_mm_h, scene.snowfall.crystal) {}

FlakeMotion::Moment FlakeMotion::moment(double time_s, double rate_mm_h) const {
  return {time_s, gunn_marshall(rate_mm_h).lambda_per_mm, wind_.common(time_s),
          wind_.moment(time_s)};
}

FlakeMotion::Drifting FlakeMotion::drifting(std::uint64_t population_key, std::uint64_t index,
                                            const Moment& moment, const PeriodicCube& cube) const {
  const std::uint64_t key = mixed(population_key ^ index);
  const std::uint64_t start = mixed(key ^ key_of("start"));
  const FlakeSizes::Body body = sizes_.body(key);
  glm::dvec3 way_m = moment.common.way_m - cube.low_m;
  way_m.z -= body.speed_m_s * moment.time_s;
  const double per_side = 1.0 / cube.side_m;
  glm::dvec3 place_m;
  for (glm::length_t axis = 0; axis < 3; ++axis)
    place_m[axis] =
        cube.low_m[axis] + cube.side_m * fraction(third_of(start, axis) + per_side * way_m[axis]);
  return {place_m, body, key};
}

Flake FlakeMotion::flake(const Drifting& drifting, const Moment& moment) const {
  const double diameter_m = sizes_.diameter_m(drifting.body.rank, moment.lambda_per_mm);
  const Motion gust = wind_.own_gust(moment.gusts, mixed(drifting.key ^ key_of("gust")));
  const Motion swaying = sway(diameter_m, moment.time_s, mixed(drifting.key ^ key_of("sway")));
  const glm::dvec3 fall(0.0, 0.0, -drifting.body.speed_m_s);
  return {drifting.place_m + gust.way_m + swaying.way_m,
          moment.common.velocity_m_s + gust.velocity_m_s + swaying.velocity_m_s + fall, diameter_m,
          drifting.body.crystal, mixed(drifting.key ^ key_of("look"))};
}

double FlakeMotion::farthest_own_way_m() const {
  constexpr double diagonal = 1.4142136;
  return wind_.farthest_own_gust_m() + diagonal * farthest_sway_m;
}

}  // namespace wold::snow
