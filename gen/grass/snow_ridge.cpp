#include "grass/snow_ridge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wold::grass {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// Sines of 20 and 65 degrees.
constexpr float holds_none = 0.342F;
constexpr float holds_all = 0.906F;
/// Snow as thick as this share of the most covers a blade from edge to edge.
constexpr float covering = 0.25F;
/// How far a full ridge reaches over the blade's edges, in half widths.
constexpr float overhang = 1.15F;
/// Where the middle of a ridge lies above the axis, in half widths of the blade.
constexpr float seat = 0.8F;
/// Thickness of the most snow on a level blade.
constexpr auto thickest_m = static_cast<float>(leaf_snow_kg_m2 / blade_snow_kg_m3);

/// Rank of a place among all the places of blades: a triangle wave with the blade's own phase, so
/// that ranks are uniform; it sways, so that lumps do not lie like beads on a string.
float rank_of(const Blade& blade, float along) {
  const float way = along * blade.length_m / blade.lump_m;
  const float place = way + blade.lump_phase + 0.3F * std::sin(2.1F * way + 40.0F * blade.lump_m);
  return std::abs(2.0F * (place - std::floor(place)) - 1.0F);
}

}  // namespace

float snow_held(float horizontal) { return glm::smoothstep(holds_none, holds_all, horizontal); }

float lump_thickness(double share, float rank) {
  // Places are filled in the order of their rank, each once those one thickness ahead are full; the
  // mean of clamp(filled - rank, 0, 1) is filled^2 / 2 up to 1, mirrored beyond.
  const double filled = share < 0.5 ? std::sqrt(2.0 * share) : 2.0 - std::sqrt(2.0 * (1.0 - share));
  return std::clamp(static_cast<float>(filled) - rank, 0.0F, 1.0F);
}

float SnowRidge::area_m() const {
  const float a = half_width_m;
  const float b = half_height_m;
  return pi / 4.0F * (3.0F * (a + b) - std::sqrt((3.0F * a + b) * (a + 3.0F * b)));
}

SnowRidge snow_ridge(const Blade& blade, const BladePose& pose, float along, const AxisPoint& at) {
  const float thickness = lump_thickness(double{pose.snow}, rank_of(blade, along)) *
                          snow_held(std::abs(at.tangent.x));
  const float radius_m = blade.radius_m * pose.mesophyll_width * (1.0F - along);
  SnowRidge ridge;
  ridge.centre_m = at.position_m + seat * radius_m * upper_side(at.tangent);
  if (thickness <= 0.0F || radius_m <= 0.0F) return ridge;
  ridge.half_width_m = overhang * radius_m * std::sqrt(std::min(thickness / covering, 1.0F));
  const float section_m2 = 2.0F * radius_m * std::min(thickest_m, 2.0F * radius_m) * thickness;
  ridge.half_height_m = section_m2 / (pi * ridge.half_width_m);
  return ridge;
}

}  // namespace wold::grass
