#include "meadow/turned_blade.h"

#include <algorithm>
#include <cmath>

#include "grass/optics/flat_leaf.h"

namespace wold::meadow {
namespace {

/// A fibre after the shear that leans the grass over.
grass::Fibre leaning(grass::Fibre fibre, const glm::vec2& lean) {
  fibre.tangent = glm::normalize(fibre.tangent + glm::vec3(lean * fibre.tangent.z, 0.0F));
  return fibre;
}

/// Of the part of the slope that the wind has added.
float turned_fraction(const glm::vec3& combed_tangent, const glm::vec2& added) {
  constexpr float flattest = 1e-3F;
  const glm::vec2 own = glm::vec2(combed_tangent) / std::max(std::abs(combed_tangent.z), flattest);
  const float by_wind = glm::dot(added, added);
  return by_wind / (by_wind + glm::dot(own, own));
}

}  // namespace

TurnedBlade turned_by_wind(const grass::Fibre& upright, const glm::vec2& combed,
                           const glm::vec2& lean) {
  constexpr float least = 1e-6F;
  TurnedBlade blade{leaning(upright, lean)};
  const glm::vec2 added = lean - combed;
  const glm::vec3 across = glm::cross(blade.fibre.tangent, glm::vec3(added, 0.0F));
  const float sine = glm::length(across);
  if (sine < least) return blade;
  blade.normal = glm::cross(across / sine, blade.fibre.tangent);
  blade.turned = turned_fraction(leaning(upright, combed).tangent, added);
  return blade;
}

float shown_area(const TurnedBlade& blade, const glm::vec3& direction) {
  const float any_way = grass::kajiya_kay_diffuse(blade.fibre.tangent, direction);
  if (blade.turned == 0.0F) return any_way;
  return glm::mix(any_way, grass::flat_leaf_area(blade.normal, direction), blade.turned);
}

}  // namespace wold::meadow
