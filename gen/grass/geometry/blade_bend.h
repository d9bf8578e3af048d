#pragma once

#include <compare>
#include <glm/glm.hpp>
#include <string>

#include "core/tubes.h"
#include "grass/geometry/blade_places.h"

namespace wold::grass {

/// By how much a cantilever under an even load turns at s = `along` of the way to its tip, over the
/// angle by which its tip lies off, to first order: 4/3 (1 - (1 - s)^3) ([Timoshenko1955]). At its
/// foot it stays as it grew.
double cantilever_turn(double along);

/// A vector turned over towards a direction along the ground: by the length of `angle_rad`, which
/// lies along that direction.
glm::dvec3 turned_over(const glm::dvec3& v, const glm::dvec2& angle_rad);

/// How wind bends all blades of a patch, by cantilever_turn(): one of the few states that meshes
/// are made for.
struct BladeBend {
  static constexpr double step_rad = 0.08726646259971647;  ///< 5 degrees

  /// By how much tips lie off, along the ground, in step_rad.
  int east = 0, north = 0;

  bool is_none() const { return east == 0 && north == 0; }
  auto operator<=>(const BladeBend&) const = default;
};

/// What to append to a mesh's name, safe in a file name: nothing where it is unbent.
std::string suffix_of(const BladeBend& bend);

/// How far it puts the tip of a straight upright blade aside over how high it leaves it, east and
/// north.
glm::dvec2 tip_lean(const BladeBend& bend);

/// The state nearest to a lean, metres along the ground per metre of height, of those whose steps
/// both ways are multiples of `multiple`.
BladeBend nearest_bend(const glm::dvec2& lean, int multiple);

/// The tubes of a patch, straight ones with `places` as blade_tubes() makes them, bent: each blade
/// by itself, as long as before, its snow with it, and the flower on its tip. What would sink below
/// the ground lies on it, but for petals.
Tubes bent(const Tubes& straight, const BladePlaces& places, const BladeBend& bend);

}  // namespace wold::grass
