#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/noise.h"
#include "terrain/trodden.h"

namespace wold::terrain {

/// Steps that grazing animals tread into steep meadows: bare, level treads nearly along the
/// contour, and risers between them with grass on. Sheep made them 0.8 m wide and 0.4 m high on
/// average, best developed where slopes are of 23 to 31 degrees and nowhere below 15 [Higgins1982].
/// These are those of cattle, 0.7 m high, in places where herds stay, tens of metres wide, and
/// fewer from 33 degrees to 42: those numbers, and how level the treads are, are modelling choices.
/// A keyed function of the place.
class GrazingSteps {
 public:
  /// `share`: of such slopes that have steps, in [0, 1]. Rock is where it is as steep as
  /// `rock_slope_deg`.
  GrazingSteps(double share, double rock_slope_deg, std::uint64_t seed);

  /// Of a place at a height, where `ascent` is the steepest ascent, as a map with that step shows
  /// it. What stands out there stays: Trodden::level is 0.
  Trodden at(const glm::dvec3& at_m, const glm::dvec2& ascent, double step_m) const;

 private:
  double fits(double slope) const;
  double trodden_by_herds(const glm::dvec2& at_m) const;

  double rock_slope_deg_;
  double least_;  ///< of the herds' field, a standard normal one, where there are steps
  Fbm herds_, winding_, wear_;
};

}  // namespace wold::terrain
