#include "snow/blowing_snow.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/random.h"

namespace wold::snow {
namespace {

constexpr double wet_from_c = 0.0;
constexpr double wet_lifting_m_s = 9.9;
constexpr double coldest_c = -45.0;  ///< [Li1997]'s fit ends there

constexpr double ice_kg_m3 = 917.0;

/// Height at which gusts are felt by what the wind lifts.
constexpr double gust_height_m = 1.0;

// Streamers, looked at: films of blowing snow show bands a few metres wide that break up within
// some ten times their width.
constexpr double widest_m = 2.5, narrowest_m = 0.2;
constexpr double length_over_width = 7.0;
constexpr double streamer_hurst = 0.5;
constexpr double streamer_deviation = 0.9;                  ///< of ln extinction, at the ground
constexpr double streamer_height_m = 0.7;                   ///< over which they fade into haze
constexpr double slow_height_m = 0.1, fast_height_m = 1.0;  ///< whose winds carry them

// [Pomeroy1992]: 0.8 kg/m^3 exp(-1.55 (4.784 u*^-0.544 - z^-0.544)).
constexpr double leaping_kg_m3 = 0.8, rate = 1.55, power = -0.544, reference = 4.784;

double leaping_height_m(double friction_m_s) { return 0.08436 * math::pow(friction_m_s, 1.27); }

/// What of that law does not depend on the height. Snow is not lifted at once everywhere.
double suspension_factor_kg_m3(double friction_m_s, double lifting_m_s) {
  constexpr double lifts_all = 1.1;  // over the friction velocity that begins to
  const double lifted = glm::smoothstep(1.0, lifts_all, friction_m_s / lifting_m_s);
  if (lifted <= 0.0) return 0.0;
  return leaping_kg_m3 * lifted * math::exp(-rate * reference * math::pow(friction_m_s, power));
}

constexpr int height_steps = 512;

}  // namespace

double lifting_wind_m_s(double temperature_c) {
  if (temperature_c > wet_from_c) return wet_lifting_m_s;
  const double t = std::max(temperature_c, coldest_c);
  return 9.43 + 0.18 * t + 0.0033 * t * t;
}

double friction_over_blowing_snow_m_s(double wind_m_s) {
  return 0.02264 * math::pow(wind_m_s, 1.295);
}

double suspended_kg_m3(double height_m, double friction_m_s, double lifting_m_s) {
  const double factor = suspension_factor_kg_m3(friction_m_s, lifting_m_s);
  if (factor <= 0.0) return 0.0;
  const double z = std::max(height_m, leaping_height_m(friction_m_s));
  return factor * math::exp(rate * math::pow(z, power));
}

double grain_extinction_m2_per_kg(double height_m) {
  constexpr double least_m = 0.005, efficiency = 2.0;
  const double z = std::max(height_m, least_m);
  const double mean_radius_m = 4.6e-5 * math::pow(z, -0.258);
  const double shape = std::min(4.08 + 12.6 * z, 25.0);  // of the gamma distribution of radii
  const double effective_radius_m = mean_radius_m * (shape + 2.0) / shape;
  return 0.75 * efficiency / (ice_kg_m3 * effective_radius_m);
}

BlowingSnow::BlowingSnow(const wind::AirFlow& air, const wind::Moment& now, double temperature_c,
                         std::uint64_t seed, double step_m)
    : air_(air),
      now_(now),
      lifting_friction_m_s_(friction_over_blowing_snow_m_s(lifting_wind_m_s(temperature_c))),
      axes_(now.heading_deg),
      gusts_(air.gusts().waves(gust_height_m, now)),
      slow_(random_bits({seed, key_of("streamers"), 0}), {widest_m, narrowest_m}, streamer_hurst,
            step_m),
      fast_(random_bits({seed, key_of("streamers"), 1}), {widest_m, narrowest_m}, streamer_hurst,
            step_m),
      heights_(heights()) {}

std::vector<BlowingSnow::Height> BlowingSnow::heights() {
  std::vector<Height> heights;
  for (int i = 0; i <= height_steps; ++i) {
    constexpr double least_m = 0.001;  // nothing is asked for so near the ground
    const double root = static_cast<double>(i) / height_steps;
    const double z = std::max(root * root * blown_depth_m, least_m);
    heights.push_back({rate * math::pow(z, power) + math::log(grain_extinction_m2_per_kg(z)),
                       streamer_deviation * math::exp(-z / streamer_height_m)});
  }
  return heights;
}

BlowingSnow::Height BlowingSnow::at(double height_m) const {
  const double step = height_steps * std::sqrt(height_m / blown_depth_m);
  const int low = std::clamp(static_cast<int>(step), 0, height_steps - 1);
  const Height& below = heights_[static_cast<std::size_t>(low)];
  const Height& above = heights_[static_cast<std::size_t>(low) + 1];
  return {std::lerp(below.ln_m2_per_kg, above.ln_m2_per_kg, step - low),
          std::lerp(below.deviation, above.deviation, step - low)};
}

/// Two fields that different winds carry: they change as they go.
double BlowingSnow::streamer(const glm::dvec2& place_m) const {
  const double along_m = glm::dot(place_m, axes_.along), right_m = glm::dot(place_m, axes_.right);
  const auto carried = [&](const ScaleFreeNoise& noise, double height_m) {
    const double way_m = now_.run_m * air_.profile().at(height_m);
    return noise.at({(along_m - way_m) / length_over_width, right_m});
  };
  return (carried(slow_, slow_height_m) + carried(fast_, fast_height_m)) * std::sqrt(0.5);
}

BlowingSnow::Lift BlowingSnow::lift(const glm::dvec2& place_m) const {
  const double mean_m_s =
      now_.speed_m_s * glm::length(air_.speed_up().mean(place_m, axes_.along, gust_height_m));
  const double gusty_m_s = mean_m_s * std::max(0.0, 1.0 + gust_at(gusts_, place_m).x);
  const double friction_m_s = friction_over_blowing_snow_m_s(gusty_m_s);
  return {suspension_factor_kg_m3(friction_m_s, lifting_friction_m_s_),
          leaping_height_m(friction_m_s)};
}

glm::dvec2 BlowingSnow::foot_m(const glm::dvec2& place_m, double height_m) const {
  // By 14.4 degrees, at any speed ([Marusic2007]).
  constexpr double way_over_height = 3.9;
  return place_m - way_over_height * std::max(height_m, 0.0) * axes_.along;
}

double BlowingSnow::extinction_per_m(const Lift& foot, double streamer, double height_m) const {
  if (foot.factor <= 0.0 || height_m >= blown_depth_m) return 0.0;
  const Height height = at(std::max(height_m, foot.leaping_m));
  // Of mean 1 over all streamers.
  const double variance = height.deviation * height.deviation * slow_.shown();
  const double ln_streamer = height.deviation * streamer - 0.5 * variance;
  const double left = 1.0 - glm::smoothstep(0.4 * blown_depth_m, blown_depth_m, height_m);
  return foot.factor * left * math::exp(height.ln_m2_per_kg + ln_streamer);
}

}  // namespace wold::snow
