#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "scene/calendar.h"
#include "scene/shots.h"

namespace wold::place {

/// Whether no more than a week of a season is between two frames, from 1.
inline bool in_a_week(const scene::Scene& scene, int frame, int other) {
  constexpr double days = 7.0;
  return std::abs(scene::season_days(scene, frame) - scene::season_days(scene, other)) <= days;
}

/// Whether the frame (from 1) before or after this one is of the same week and shot of a season.
/// Where none is, a frame is a picture of its own day, of which no film is made.
inline bool has_nearby_frames(const scene::Scene& scene, int frame) {
  const scene::Take take = scene::take_of(scene, frame);
  return (frame > take.first && in_a_week(scene, frame, frame - 1)) ||
         (frame < take.last() && in_a_week(scene, frame, frame + 1));
}

/// The mean of value(frame), a number, over a frame (from 1) of a season and the two to either
/// side, those nearest counting most, as far as no cut and no more than a week is between; of any
/// other film the frame's own. Weather changes from one day to the next, which a sky that did so
/// too would show as flicker.
template <class Value>
double mean_of_nearby(const scene::Scene& scene, int frame, const Value& value) {
  if (!scene::is_season(scene)) return value(frame);
  constexpr int reach = 3;
  const scene::Take take = scene::take_of(scene, frame);
  double sum = 0.0, weights = 0.0;
  for (int near = std::max(take.first, frame - reach + 1);
       near <= std::min(take.last(), frame + reach - 1); ++near) {
    if (!in_a_week(scene, frame, near)) continue;
    const double weight = reach - std::abs(near - frame);
    sum += weight * value(near);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace wold::place
