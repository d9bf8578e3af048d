#include "snow/bedforms.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/ground_map.h"
#include "core/random.h"

namespace wold::snow {
namespace {

constexpr double hour_s = 3600.0;
constexpr double places_m = 14.0;          // size of the places where one form prevails
constexpr glm::dvec2 largest_m(5.0, 9.0);  // forms, along the wind and across it

std::uint64_t key(std::uint64_t seed, std::string_view what) {
  return random_bits({seed, key_of("snow cover"), 0, key_of(what)});
}

/// How far a wind shapes snow if it lasts.
double shaped_at_last(double wind_m_s) {
  constexpr double flat_m_s = 6.4, all_m_s = 10.0;
  return glm::smoothstep(flat_m_s, all_m_s, wind_m_s);
}

/// After some hours of one weather.
double shaped_after(double shaped, const WeatherMoment& weather, double height_m, double hours) {
  constexpr double shaping_h = 3.0, levelling_h = 24.0;
  constexpr double buried_mm = 10.0;  // of water, in a decimetre of fresh snow
  if (weather.temperature_c > lapse_k_per_m * height_m)
    return shaped * math::exp(-hours / levelling_h);
  shaped *= math::exp(-snow_mm_h(weather, height_m) * hours / buried_mm);
  const double at_last = shaped_at_last(weather.wind_speed_m_s);
  return shaped + std::max(at_last - shaped, 0.0) * (1.0 - math::exp(-hours / shaping_h));
}

}  // namespace

double shaped_by_wind(const Weather& weather, double time_s, double height_m, bool lain) {
  double shaped = lain ? 1.0 : 0.0;
  bool lies = lain;
  for (double at_s = -weather.earlier_s(); at_s < time_s; at_s += hour_s) {
    const double passed_s = std::min(hour_s, time_s - at_s);
    const WeatherMoment now = weather.at(at_s + 0.5 * passed_s);
    lies = lies || snow_mm_h(now, height_m) > 0.0;
    if (lies) shaped = shaped_after(shaped, now, height_m, passed_s / hour_s);
  }
  return shaped;
}

double shaping_heading_deg(const Weather& weather) {
  const glm::dvec2 way_m = weather.wind_way_m(0.0);
  return glm::length(way_m) > 0.0 ? math::atan2(way_m.x, way_m.y) * degrees_per_radian
                                  : weather.at(0.0).wind_heading_deg;
}

Bedforms::Bedforms(double heading_deg, std::uint64_t seed)
    : axes_(heading_deg),
      sastrugi_(octaves(key(seed, "sastrugi"), {2.4, 0.7}, 0.03, 5)),
      waves_(octaves(key(seed, "snow waves"), largest_m, 0.035, 2)),
      ripples_(octaves(key(seed, "ripples"), {0.13, 0.9}, 0.002, 2)),
      crust_(octaves(key(seed, "wind crust"), {0.16, 0.1}, 0.0006, 4)),
      carved_{key(seed, "carved"), 3, 0.5},
      rippled_{key(seed, "rippled"), 3, 0.5} {}

Bedforms::Form Bedforms::octaves(std::uint64_t key, const glm::dvec2& largest_m, double height_m,
                                 int count) {
  constexpr double hurst = 0.65;
  Form form;
  for (int k = 0; k < count; ++k) {
    const auto octave = static_cast<std::uint64_t>(k);
    const glm::dvec2 shift(random_uniform({key, key_of("shift"), octave, 0}),
                           random_uniform({key, key_of("shift"), octave, 1}));
    form.push_back({math::exp2(-1.0 * k) * largest_m, math::exp2(-hurst * k) * height_m, shift,
                    random_bits({key, key_of("field"), octave, 0})});
  }
  return form;
}

/// Height and steepest ascent at a place, along the wind and across it.
NoiseSlope Bedforms::relief(const Form& form, const glm::dvec2& wind_m, double step_m) {
  NoiseSlope relief;
  for (const Octave& octave : form) {
    const double shown = shown_fraction(std::min(octave.feature_m.x, octave.feature_m.y), step_m);
    if (shown <= 0.0) break;
    const NoiseSlope noise =
        gradient_noise_slope(wind_m / octave.feature_m + octave.shift, octave.key);
    const double height_m = shown * octave.height_m / gradient_noise_deviation;
    relief.value += height_m * noise.value;
    relief.gradient += height_m * noise.gradient / octave.feature_m;
  }
  return relief;
}

/// Steepest ascent of crests where the relief is zero: sharp along the wind, and steep against it.
glm::dvec2 Bedforms::ridges(const Form& form, const glm::dvec2& wind_m, double step_m) {
  constexpr double blunt = 0.35;  // deviations of the relief, about which a crest is round
  constexpr double undercut = 1.2, steepest = 2.5;
  const NoiseSlope under = relief(form, wind_m, step_m);
  if (under.gradient == glm::dvec2(0.0)) return under.gradient;
  const double round_m = blunt * form.front().height_m;
  const glm::dvec2 ascent =
      under.gradient * (-under.value / std::sqrt(under.value * under.value + round_m * round_m));
  // A surface that leans against the wind by some times its height.
  return ascent * std::min(1.0 / std::max(1.0 - undercut * ascent.x, 1e-3), steepest);
}

bool Bedforms::is_shown(double step_m) { return shown_fraction(largest_m.x, step_m) > 0.0; }

glm::dvec2 Bedforms::ascent(const glm::dvec2& at_m, double step_m) const {
  if (!is_shown(step_m)) return glm::dvec2(0.0);
  const glm::dvec2 wind_m(glm::dot(at_m, axes_.along), glm::dot(at_m, axes_.right));
  const double carved = glm::smoothstep(-0.8, 0.9, carved_.at(at_m / places_m));
  const double rippled = glm::smoothstep(0.0, 1.2, rippled_.at(at_m / places_m)) * (1.0 - carved);
  glm::dvec2 ascent =
      relief(waves_, wind_m, step_m).gradient + relief(crust_, wind_m, step_m).gradient;
  if (carved > 0.0) ascent += carved * ridges(sastrugi_, wind_m, step_m);
  if (rippled > 0.0) ascent += rippled * relief(ripples_, wind_m, step_m).gradient;
  return axes_.on_ground(ascent);
}

}  // namespace wold::snow
