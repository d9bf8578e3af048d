#pragma once

#include <algorithm>
#include <cstdlib>

#include "scene/calendar.h"

namespace wold::place {

/// The mean of value(frame), a number, over a frame (from 1) of a season and the two to either
/// side, those nearest counting most; of any other film the frame's own. Weather changes from one
/// day to the next, which a sky that did so too would show as flicker.
template <class Value>
double mean_of_nearby(const scene::Scene& scene, int frame, const Value& value) {
  if (!scene::is_season(scene)) return value(frame);
  constexpr int reach = 3;
  double sum = 0.0, weights = 0.0;
  for (int near = std::max(1, frame - reach + 1);
       near <= std::min(scene.season.frames, frame + reach - 1); ++near) {
    const double weight = reach - std::abs(near - frame);
    sum += weight * value(near);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace wold::place
