#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "scene/calendar.h"
#include "scene/shots.h"

namespace wold::place {

/// The mean of value(frame), a number, over a frame (from 1) of a season and the two to either
/// side, those nearest counting most, as far as no cut and no more than a week is between; of any
/// other film the frame's own. Weather changes from one day to the next, which a sky that did so
/// too would show as flicker. Frames that are farther apart are pictures of their own days.
template <class Value>
double mean_of_nearby(const scene::Scene& scene, int frame, const Value& value) {
  if (!scene::is_season(scene)) return value(frame);
  constexpr int reach = 3;
  constexpr double most_days = 7.0;
  const scene::Take take = scene::take_of(scene, frame);
  double sum = 0.0, weights = 0.0;
  for (int near = std::max(take.first, frame - reach + 1);
       near <= std::min(take.last(), frame + reach - 1); ++near) {
    const double days = scene::season_days(scene, near) - scene::season_days(scene, frame);
    if (std::abs(days) > most_days) continue;
    const double weight = reach - std::abs(near - frame);
    sum += weight * value(near);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace wold::place
