#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

#include "grass/geometry/blade.h"

namespace wold::grass {

/// Points of Algorithm 1 ([TVT], section 2.3) along a blade's vein, from the root to the tip, at
/// equal distances, within the blade's vertical plane: (along heading, up), the root at zero. What
/// else a section of the blade has of points is bonded to it and rides along.
struct VeinPoints {
  static constexpr std::size_t segments = vein_segments;
  template <class T>
  using OfPoints = std::array<T, segments + 1>;

  std::array<double, segments> angle{};  ///< of each segment from the upward vertical, rad
  OfPoints<glm::dvec2> position_m{};
  OfPoints<glm::dvec2> velocity_m_s{};
  OfPoints<double> mass_kg{};
  OfPoints<glm::dvec2> force_n{};  ///< all forces on a point together, at the last step
};

/// Along a segment with that angle, and the direction its end moves to as the angle grows.
glm::dvec2 along(double angle);
glm::dvec2 aside(double angle);

/// Places of the points of a vein with those angles.
VeinPoints::OfPoints<glm::dvec2> places_m(const std::array<double, vein_segments>& angle,
                                          double length_m);

/// A straight vein at rest.
VeinPoints straight_vein(double lean, double length_m);

/// Shares a mass out to the points: half as much to the two at the ends.
void set_mass(VeinPoints& points, double mass_kg);

}  // namespace wold::grass
