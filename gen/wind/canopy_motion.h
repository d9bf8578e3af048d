#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "wind/air_flow.h"
#include "wind/beam.h"
#include "wind/moment.h"
#include "wind/wave_sum.h"

namespace wold::wind {

/// How the blades of a canopy answer the wind at one moment.
///
/// The wind on them is made of waves, and a blade is a damped oscillator, so that its answer is
/// made of the same waves, each with the gain and the lag of its frequency (beam.h): no earlier
/// moment is needed. Drag goes with the square of the wind; the square is taken of the answer,
/// which is exact for gusts that are slow beside the blades. A cell's grass moves as one: it feels
/// the mean of each wave over the cell.
class CanopyMotion {
 public:
  /// `cell_m`: side of the square that moves as one, 0 of single blades.
  CanopyMotion(std::shared_ptr<const AirFlow> flow, const Moment& now, const Beam& beam,
               double cell_m);

  /// The load of the wind at a place, as the angle that it would bend an upright blade by that
  /// stays in its way (streamlining.h): radians east and north.
  glm::dvec2 load(const glm::dvec2& place_m) const;

 private:
  std::shared_ptr<const AirFlow> flow_;
  glm::dvec2 heading_;
  double steady_load_ = 0.0;
  WaveSum gusts_along_, gusts_across_, honami_;  ///< as blades answer them, over the mean wind
};

}  // namespace wold::wind
