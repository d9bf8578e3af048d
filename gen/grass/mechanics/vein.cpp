#include "grass/mechanics/vein.h"

#include <cmath>

#include "core/elementary.h"

namespace wold::grass {

glm::dvec2 along(double angle) { return {math::sin(angle), math::cos(angle)}; }
glm::dvec2 aside(double angle) { return {math::cos(angle), -math::sin(angle)}; }

VeinPoints::OfPoints<glm::dvec2> places_m(const std::array<double, vein_segments>& angle,
                                          double length_m) {
  VeinPoints::OfPoints<glm::dvec2> places{};
  const double segment_m = length_m / vein_segments;
  for (std::size_t k = 0; k < angle.size(); ++k)
    places[k + 1] = places[k] + segment_m * along(angle[k]);
  return places;
}

VeinPoints straight_vein(double lean, double length_m) {
  VeinPoints points;
  points.angle.fill(lean);
  points.position_m = places_m(points.angle, length_m);
  return points;
}

void set_mass(VeinPoints& points, double mass_kg) {
  points.mass_kg.fill(mass_kg / vein_segments);
  points.mass_kg.front() *= 0.5;
  points.mass_kg.back() *= 0.5;
}

}  // namespace wold::grass
