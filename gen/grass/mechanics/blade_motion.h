#pragma once

#include <array>
#include <vector>

#include "core/curve.h"
#include "grass/mechanics/vein_forces.h"
#include "grass/mechanics/wall.h"
#include "scene/scene.h"

namespace wold::grass {

/// The shape of a blade's vein at an age, and what it keeps of the ages before.
struct VeinState {
  std::array<double, vein_segments> angle{};  ///< of its segments from the upward vertical, rad
  Wall wall;
  double droop = 0.0;  ///< c of [TVT]'s rule, rad / sqrt(m)
};

/// Algorithm 1 on one blade: its points from the first age on, in equal steps of its own weathering
/// degree. By ageing.droop_rule they fall as [TVT]'s law says or under the forces on them.
///
/// A state depends on the age alone, whatever was asked for before: between two steps it is
/// interpolated.
class BladeMotion {
 public:
  static constexpr int usual_steps = 64;

  /// At age 0. `ageing` and `water` have to outlive it.
  BladeMotion(const Blade& blade, const scene::Physiology& ageing, const Curve& water,
              int steps = usual_steps);

  /// The state at an age in [0, 1], not before the last one.
  const VeinState& at(double age);
  /// The points after the last whole step.
  const VeinPoints& points() const { return points_; }

 private:
  void step();

  Blade blade_;
  const scene::Physiology* ageing_;
  const Curve* water_;
  int steps_;
  int done_ = 0;
  VeinPoints points_;
  VeinState before_, last_, now_;
};

/// The same at any age, in any order: the states of all steps.
class BladeHistory {
 public:
  BladeHistory() = default;
  BladeHistory(const Blade& blade, const scene::Physiology& ageing, const Curve& water);
  VeinState at(double age) const;

 private:
  std::vector<VeinState> states_;
};

/// Places of the vein of a blade in a state, `water_lost` now, under the fraction `snow` of the
/// snow it can carry (0 to 1), which leaves no trace.
VeinPlaces vein_places(const Blade& blade, const scene::Physiology& ageing, const VeinState& state,
                       double water_lost, double length_m, double snow);

}  // namespace wold::grass
