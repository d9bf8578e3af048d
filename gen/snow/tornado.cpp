#include "snow/tornado.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/random.h"
#include "core/simd_turns.h"

namespace wold::snow {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double widening = 2.4849066;  ///< k = log 12
constexpr double core = 0.6;            ///< r_c over the funnel's radius
constexpr double updraught = 0.35;      ///< w over v_core
constexpr double fraction_at_foot = 0.2;

/// v r_c / (v_core r), Burgers and Rott's angular speed, at a radius in units of the funnel's.
double angular_speed(double radius) {
  const double x = radius / core;
  return 1.398 / (x * x) * (1.0 - math::exp(-1.256 * x * x));
}

}  // namespace

Tornado::Tornado(const scene::PrecipitationPart& part, std::uint64_t key, std::uint64_t flakes)
    : key_(key),
      flakes_(flakes),
      middle_m_(0.5 * part.terrain_m),
      wander_m_(0.1 * part.terrain_m),
      height_m_(std::clamp(0.6 * part.terrain_m, 10.0, 120.0)),
      foot_radius_m_(0.02 * height_m_),
      speed_m_s_(std::max(8.0, 4.0 * part.wind.speed_m_s)) {
  constexpr double optical_depth = 0.6;
  const double silhouette_m2 =
      2.0 * height_m_ * foot_radius_m_ * (math::exp(widening) - 1.0) / widening;
  flake_m_ = std::sqrt(
      optical_depth * silhouette_m2 /
      (0.25 * std::numbers::pi * static_cast<double>(std::max<std::uint64_t>(flakes, 1))));
}

double Tornado::draw(std::uint64_t i, std::uint64_t purpose) const {
  return random_uniform({key_, key_of("tornado"), i, purpose});
}

glm::dvec2 Tornado::foot_m(double time_s) const {
  constexpr double east_period_s = 47.0, north_period_s = 61.0;
  return middle_m_ + wander_m_ * glm::dvec2(math::sin(two_pi * time_s / east_period_s),
                                            math::sin(two_pi * time_s / north_period_s));
}

Tornado::Whirl Tornado::rising(std::uint64_t i, double time_s) const {
  // Mostly about the radius where they are fastest, few inside, ragged outside.
  const double fraction = 0.25 + 0.5 * std::sqrt(draw(i, key_of("radius"))) +
                          0.6 * math::pow(draw(i, key_of("radius too")), 3.0);
  const double up_m_s = updraught * speed_m_s_ * (0.6 + 0.8 * draw(i, key_of("rise")));
  const double cycles = time_s * up_m_s / height_m_ + draw(i, key_of("start"));
  const double cycle = std::floor(cycles);
  const double s = cycles - cycle;
  const double radius_m = fraction * foot_radius_m_ * math::exp(widening * s);
  // v / r = angular_speed v_core / r_c and ds / dt = w / H.
  const double per_height =
      angular_speed(fraction) * speed_m_s_ / (core * foot_radius_m_) * height_m_ / up_m_s;
  const double angle =
      two_pi * draw(i ^ mixed(static_cast<std::uint64_t>(static_cast<std::int64_t>(cycle))),
                    key_of("angle")) +
      per_height * (1.0 - math::exp(-widening * s)) / widening;
  const double ahead_m_s = angular_speed(fraction) * speed_m_s_ /
                           (core * foot_radius_m_ * math::exp(widening * s)) * radius_m;
  return {radius_m,
          s * height_m_,
          angle,
          {widening * radius_m * up_m_s / height_m_, ahead_m_s, up_m_s}};
}

Tornado::Whirl Tornado::about_the_foot(std::uint64_t i, double time_s) const {
  const double fraction = 1.0 + 4.0 * draw(i, key_of("radius")) * draw(i, key_of("radius too"));
  const double radius_m = fraction * foot_radius_m_;
  const double per_s = angular_speed(fraction) * speed_m_s_ / (core * foot_radius_m_);
  const double top_m = 0.12 * height_m_ / fraction;
  const double phase = draw(i, key_of("start")) + 0.3 * time_s;
  const double bob =
      0.5 - 0.5 * static_cast<double>(cosine_of_turns(static_cast<float>(off_whole(phase))));
  return {radius_m,
          top_m * bob * draw(i, key_of("rise")),
          two_pi * draw(i, key_of("angle")) + per_s * time_s,
          {0.0, per_s * radius_m, 0.0}};
}

Flake Tornado::flake(std::uint64_t i, double time_s, double ground_m) const {
  const bool at_foot = draw(i, key_of("place")) < fraction_at_foot;
  const Whirl whirl = at_foot ? about_the_foot(i, time_s) : rising(i, time_s);
  const glm::dvec2 outwards(math::cos(whirl.angle), math::sin(whirl.angle));
  const glm::dvec2 ahead(-outwards.y, outwards.x);
  const double s = whirl.height_m / height_m_;
  constexpr double bends = 0.6, sways_per_s = 0.1, bent = 0.08;
  const double way =
      bent * height_m_ * s * s * math::sin(two_pi * (bends * s - sways_per_s * time_s));
  const glm::dvec2 at = foot_m(time_s) + glm::dvec2(way, 0.6 * way) + whirl.radius_m * outwards;
  const glm::dvec2 level = whirl.velocity_m_s.x * outwards + whirl.velocity_m_s.y * ahead;
  const std::uint64_t bits = random_bits({key_, key_of("tornado"), i, key_of("look")});
  // As fast as flakes that fall, FlakeMotion's.
  const double spin_per_s = 2.5 * draw(i, key_of("spin rate")) - 1.25;
  const double tilt_per_s = 0.5 + 2.0 * draw(i, key_of("tilt rate"));
  return {{at, ground_m + whirl.height_m},
          {level, whirl.velocity_m_s.z},
          flake_m_ * (0.6 + 0.8 * draw(i, key_of("size"))),
          Crystal::aggregate,
          bits,
          1.0F,
          static_cast<float>(off_whole(draw(i, key_of("spin")) + spin_per_s * time_s)),
          static_cast<float>(off_whole(draw(i, key_of("tilt")) + tilt_per_s * time_s))};
}

}  // namespace wold::snow
