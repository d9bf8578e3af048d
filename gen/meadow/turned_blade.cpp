#include "meadow/turned_blade.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "grass/geometry/blade_bend.h"
#include "grass/optics/flat_leaf.h"

namespace wold::meadow {
namespace {

/// A fibre after the shear that combs the grass over.
grass::Fibre combed_over(grass::Fibre fibre, const glm::vec2& lean) {
  fibre.tangent = glm::normalize(fibre.tangent + glm::vec3(lean * fibre.tangent.z, 0.0F));
  return fibre;
}

/// Angle from the vertical, along the ground.
glm::dvec2 angle_rad(const glm::dvec2& lean) {
  const double height = glm::length(lean);
  return height > 0.0 ? math::atan(height) / height * lean : lean;
}

double square(double x) { return x * x; }

}  // namespace

TurnedBlade turned_by_wind(const grass::Fibre& upright, const glm::vec2& combed,
                           const glm::vec2& lean) {
  TurnedBlade blade{combed_over(upright, combed)};
  const glm::dvec2 added_rad = grass::cantilever_turn(double{upright.along}) *
                               (angle_rad(glm::dvec2(lean)) - angle_rad(glm::dvec2(combed)));
  if (added_rad == glm::dvec2(0.0)) return blade;
  const double own_rad = math::acos(std::clamp(double{blade.fibre.tangent.z}, -1.0, 1.0));
  blade.fibre.tangent = glm::vec3(grass::turned_over(glm::dvec3(blade.fibre.tangent), added_rad));
  const glm::vec3 across = glm::cross(blade.fibre.tangent, glm::vec3(added_rad, 0.0));
  const float length = glm::length(across);
  constexpr float least = 1e-6F;
  if (length < least) return blade;
  blade.normal = glm::cross(across / length, blade.fibre.tangent);
  const double by_wind = glm::dot(added_rad, added_rad);
  blade.turned = static_cast<float>(by_wind / (by_wind + square(own_rad)));
  return blade;
}

float shown_area(const TurnedBlade& blade, const glm::vec3& direction) {
  const float any_way = grass::kajiya_kay_diffuse(blade.fibre.tangent, direction);
  if (blade.turned == 0.0F) return any_way;
  return glm::mix(any_way, grass::flat_leaf_area(blade.normal, direction), blade.turned);
}

}  // namespace wold::meadow
