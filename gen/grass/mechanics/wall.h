#pragma once

#include <array>

#include "grass/mechanics/vein.h"
#include "scene/scene.h"

namespace wold::grass {

/// What drying leaves in the cell walls of a blade for good, so that a blade that is wetted again
/// gets back what turgor gives and no more.
///
/// Walls are as stiff as the most water that they ever lacked has made them. What stiffens does so
/// in the shape that the blade has just then and is free of stress in it, as in concrete that
/// solidifies under load (Bazant and Prasannan 1989, Journal of Engineering Mechanics 115:1691);
/// besides, limp walls creep. So the turn k0 at which a joint rests follows its turn k,
///   dk0 = (b / (1 + b x) + wall_creep) (k - k0) dx,  x the most water lost so far.
struct Wall {
  double max_lost = 0.0;
  std::array<double, vein_segments> set{};  ///< k0 of each joint, rad
};

/// Fraction of its elastic turn by which a joint creeps per unit of water lost (modelling choice:
/// the least with which a default meadow does not rise again by the weight that it loses; a single
/// tip does by 1.2 % of its length at most).
inline constexpr double wall_creep = 0.75;

/// Dries a blade that has these turns to `water_lost`; nothing happens while it is wetter than it
/// has been.
void dry(Wall& wall, const std::array<double, vein_segments>& turns, double water_lost,
         double stiffening);

}  // namespace wold::grass
