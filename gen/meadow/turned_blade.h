#pragma once

#include <glm/glm.hpp>

#include "grass/optics/shading.h"

namespace wold::meadow {

/// A bit of a blade in the wind. Still grass shears as it is combed; wind bends blades as
/// cantilevers (blade_bend.h), those that droop, too.
///
/// A blade is thin: it bends about its broad side alone, and twists until that side meets what
/// bends it ([Vogel1989], [Ennos1993]). So wind lays blades with their broad sides up the wind,
/// all alike, while those of still grass face all ways. Between the two it goes by the squares of
/// two angles: of its own from the vertical, which blades have each to its own side, and of what
/// the wind adds.
struct TurnedBlade {
  grass::Fibre fibre;      ///< as it leans
  glm::vec3 normal{0.0F};  ///< unit, of the broad side that the wind has turned up
  float turned = 0.0F;     ///< of such blades those that show it, 0 to 1; the others face any way
};

/// A fibre of upright grass that was combed to `combed` and leans as `lean` for a moment, both
/// metres along the ground per metre of height of tips.
TurnedBlade turned_by_wind(const grass::Fibre& upright, const glm::vec2& combed,
                           const glm::vec2& lean);

/// The area that it shows to a unit direction, over a fibre's mean over all directions.
float shown_area(const TurnedBlade& blade, const glm::vec3& direction);

}  // namespace wold::meadow
