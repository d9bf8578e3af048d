#pragma once

#include <algorithm>
#include <cstdlib>

#include "scene/calendar.h"
#include "scene/shots.h"

namespace wold::place {

/// The mean of value(frame), a number, over a frame (from 1) of a season and the two to either
/// side, those nearest counting most, as far as no cut is between; of any other film the frame's
/// own. Weather changes from one day to the next, which a sky that did so too would show as
/// flicker.
template <class Value>
double mean_of_nearby(const scene::Scene& scene, int frame, const Value& value) {
  if (!scene::is_season(scene)) return value(frame);
  constexpr int reach = 3;
  const scene::Take take = scene::take_of(scene, frame);
  double sum = 0.0, weights = 0.0;
  for (int near = std::max(take.first, frame - reach + 1);
       near <= std::min(take.last(), frame + reach - 1); ++near) {
    const double weight = reach - std::abs(near - frame);
    sum += weight * value(near);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace wold::place
