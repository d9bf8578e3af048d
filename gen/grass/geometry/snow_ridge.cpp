#include "grass/geometry/snow_ridge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/noise.h"

namespace wold::grass {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// Sines of 10 and 50 degrees.
constexpr float holds_none = 0.174F;
constexpr float holds_all = 0.766F;
/// Snow as thick as this fraction of the most covers a blade from edge to edge.
constexpr float covering = 0.5F;
/// Ranks over which the thickness of lumps falls from the most to nothing.
constexpr double edge = 0.4;
/// How far a full ridge reaches over the blade's edges, in half widths.
constexpr float overhang = 1.3F;
/// How far a ridge's lower side sinks below a blade's upper side, in half widths of the blade.
constexpr float sunk = 0.5F;
/// How high a ridge is at most, in half widths of the blade: higher ones fall off.
constexpr float highest = 3.0F;
/// Size of the tufts that snow gathers on, and how much of a place's rank is its tuft's.
constexpr double tuft_m = 0.06;
constexpr double by_tuft = 0.65;
/// Thickness of the most snow on a level blade.
constexpr auto thickest_m = static_cast<float>(leaf_snow_kg_m2 / blade_snow_kg_m3);

/// Uniform along a blade: a triangle wave with the blade's own phase; it sways, so that lumps do
/// not lie like beads on a string.
double lump_rank(const Blade& blade, float along) {
  const float way = along * blade.length_m / blade.lump_m;
  const float place = way + blade.lump_phase + 0.3F * math::sin(2.1F * way + 40.0F * blade.lump_m);
  return double{std::abs(2.0F * (place - std::floor(place)) - 1.0F)};
}

/// Uniform over the ground: smooth noise, which is nearly normal, through the normal distribution.
double tuft_rank(const Blade& blade, const AxisPoint& at) {
  const glm::dvec2 place = glm::dvec2(on_patch_m(blade, at)) / tuft_m;
  return 0.5 * math::erfc(-Fbm(blade.tufts, 2, 0.9).at(place) / std::numbers::sqrt2);
}

/// Distribution of a u + (1 - a) v, u and v uniform in [0, 1], a in [1/2, 1): makes it uniform.
double mixed_uniform(double x, double a) {
  const double b = 1.0 - a;
  if (x < b) return x * x / (2.0 * a * b);
  if (x > a) return 1.0 - (1.0 - x) * (1.0 - x) / (2.0 * a * b);
  return (x - b / 2.0) / a;
}

/// Rank of a place among all the places of blades, uniform.
float rank_of(const Blade& blade, float along, const AxisPoint& at) {
  const double mix = by_tuft * tuft_rank(blade, at) + (1.0 - by_tuft) * lump_rank(blade, along);
  return static_cast<float>(mixed_uniform(mix, by_tuft));
}

}  // namespace

float snow_held(float horizontal) { return glm::smoothstep(holds_none, holds_all, horizontal); }

float lump_thickness(double fraction, float rank) {
  // Places are filled in the order of their rank, those of the next `edge` of ranks in part; the
  // mean of clamp((filled - rank) / edge, 0, 1) is filled^2 / (2 edge) up to the edge, mirrored at
  // the other end, and linear in between.
  const auto end = [](double rest) { return std::sqrt(2.0 * edge * rest); };
  const double filled = fraction < 0.5 * edge         ? end(fraction)
                        : fraction < 1.0 - 0.5 * edge ? fraction + 0.5 * edge
                                                      : 1.0 + edge - end(1.0 - fraction);
  return std::clamp(static_cast<float>((filled - double{rank}) / edge), 0.0F, 1.0F);
}

float SnowRidge::area_m() const {
  const float a = half_width_m;
  const float b = half_height_m;
  return pi / 4.0F * (3.0F * (a + b) - std::sqrt((3.0F * a + b) * (a + 3.0F * b)));
}

SnowRidge snow_ridge(const Blade& blade, const BladePose& pose, float along, const AxisPoint& at) {
  const float thickness = lump_thickness(double{pose.snow}, rank_of(blade, along, at)) *
                          (blade.organ == Organ::disc ? 1.0F : snow_held(std::abs(at.tangent.x)));
  const float radius_m = blade.radius_m * pose.mesophyll_width * (1.0F - along);
  SnowRidge ridge;
  ridge.centre_m = at.position_m + radius_m * upper_side(at.tangent);
  if (thickness <= 0.0F || radius_m <= 0.0F) return ridge;
  ridge.half_width_m = overhang * radius_m * std::sqrt(std::min(thickness / covering, 1.0F));
  const float section_m2 = 2.0F * radius_m * std::min(thickest_m, highest * radius_m) * thickness;
  ridge.half_height_m = section_m2 / (pi * ridge.half_width_m);
  ridge.centre_m += (ridge.half_height_m - sunk * radius_m) * upper_side(at.tangent);
  return ridge;
}

}  // namespace wold::grass
