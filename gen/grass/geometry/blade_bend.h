#pragma once

#include <compare>
#include <glm/glm.hpp>
#include <string>

#include "core/tubes.h"
#include "grass/geometry/blade_places.h"

namespace wold::grass {

/// How wind bends all blades of a patch: one of the few states that meshes are made for.
///
/// A blade is a cantilever under an even load: it stays as it grew at its foot, and turns with the
/// wind by A (1 - (1 - s)^3) at s of the way to its tip ([Timoshenko1955]), which puts the tip of a
/// straight one 3 A / 4 off.
struct BladeBend {
  static constexpr double step_rad = 0.08726646259971647;  ///< 5 degrees

  /// 3 A / 4 as a vector along the ground, in step_rad.
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
/// by itself, as long as before, its snow with it. What would sink below the ground lies on it.
Tubes bent(const Tubes& straight, const BladePlaces& places, const BladeBend& bend);

}  // namespace wold::grass
