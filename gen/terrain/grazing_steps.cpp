#include "terrain/grazing_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/ground_map.h"
#include "core/normal_distribution.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

constexpr double riser_m = 0.7;                                   // mean height of a step
constexpr double tread = 0.38;                                    // its share of a step
constexpr double herds_m = 45.0, winding_m = 16.0, wear_m = 2.5;  // sizes of features

std::uint64_t key(std::uint64_t seed, std::string_view what) {
  return random_bits({seed, key_of("grazing steps"), 0, key_of(what)});
}

/// How far a place in a step, from 0 to 1 upwards, belongs to the tread.
double on_tread(double in_step) {
  constexpr double edge = 0.07;  // of a step
  const double from_middle = std::abs(in_step - 0.5);
  return 1.0 - glm::smoothstep(0.5 * tread - edge, 0.5 * tread + edge, from_middle);
}

double least_of(double share) {
  constexpr double none = std::numeric_limits<double>::infinity();
  if (share <= 0.0) return none;
  return share >= 1.0 ? -none : normal_quantile(1.0 - share);
}

}  // namespace

GrazingSteps::GrazingSteps(double share, double rock_slope_deg, std::uint64_t seed)
    : rock_slope_deg_(rock_slope_deg),
      least_(least_of(share)),
      herds_{key(seed, "herds"), 3, 0.5},
      winding_{key(seed, "winding"), 4, 0.9},
      wear_{key(seed, "wear"), 3, 0.5} {}

/// How well a slope holds them, from 0 to 1.
double GrazingSteps::fits(double slope) const {
  constexpr double none_deg = 15.0, full_deg = 23.0, still_full_deg = 33.0, slides_deg = 42.0;
  constexpr double below_rock_deg = 6.0;
  const double deg = math::atan(slope) * degrees_per_radian;
  return glm::smoothstep(none_deg, full_deg, deg) *
         (1.0 - glm::smoothstep(still_full_deg, slides_deg, deg)) *
         (1.0 - glm::smoothstep(rock_slope_deg_ - below_rock_deg, rock_slope_deg_, deg));
}

/// They come and go over some metres.
double GrazingSteps::trodden_by_herds(const glm::dvec2& at_m) const {
  constexpr double border = 0.35;
  const double herds = herds_.at(at_m / herds_m);
  return std::clamp(0.5 + (herds - least_) / border, 0.0, 1.0);
}

Trodden GrazingSteps::at(const glm::dvec3& at_m, const glm::dvec2& ascent, double step_m) const {
  constexpr double uneven = 0.2;                   // of the wear
  constexpr double levelled = 0.7, winding = 0.9;  // of the slope; of a step's height
  const double slope = glm::length(ascent);
  const glm::dvec2 place(at_m);
  const double there = fits(slope) * trodden_by_herds(place);
  if (there <= 0.0) return {};
  const double steps = at_m.z / riser_m + winding * winding_.at(place / winding_m);
  const double shown = shown_fraction(riser_m / slope, step_m);
  const double here = on_tread(steps - std::floor(steps));
  const double seen = std::lerp(tread, here, shown);
  const double wear =
      there * std::clamp(1.0 - uneven + uneven * wear_.at(place / wear_m), 0.2, 1.0);
  // What treads are less steep risers are steeper.
  const double flatter = levelled * (here - tread) / (1.0 - tread);
  return {.bare = wear * seen, .gradient = -wear * shown * flatter * ascent};
}

}  // namespace wold::terrain
