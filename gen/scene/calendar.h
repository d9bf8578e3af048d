#pragma once

#include <chrono>

#include "scene/scene.h"
#include "scene/sun_position.h"

/// When frames are: a film has the clock of what moves, clouds, and that of the weather, which
/// withers grass and lets snow fall. They are the same but in a season without shots, where days
/// pass from frame to frame. The clock of a season of shots is that of the world: it begins at
/// midnight, universal time, of the season's first day.
namespace wold::scene {

inline bool is_season(const Season& season) { return !season.first.empty(); }
inline bool is_season(const Scene& scene) { return is_season(scene.season); }

/// Days from a season's first to its last.
double season_length_days(const Season& season);

/// The hour of a season's first day, universal time, at which the weather's clock begins.
double clock_begins_h(const Scene& scene);

/// The weather's clock at a frame (from 1): seconds since the first frame, or, of a film of shots,
/// since the clock's beginning.
double time_s(const Scene& scene, int frame);

/// The latest that it is in any frame.
double film_s(const Scene& scene);

/// Where a frame (from 1) lies among the days of a season, from 0, the first: what is so on a day
/// is so at a whole number, and linear between. Days of a film of shots are so at their noon.
double season_days(const Scene& scene, int frame);

/// Whether so much time passes in a season from a frame (from 1) to the next that clouds would
/// jump: in every season without shots, and in shots whose frames are an hour or more apart.
bool is_time_lapse(const Scene& scene, int frame);

/// The clouds' clock from a frame (from 1) to the next: in a time lapse film.frame_seconds, else as
/// much as passes.
double cloud_step_s(const Scene& scene, int frame);

/// The clouds' clock at a frame (from 1): a shot begins when it is.
double cloud_time_s(const Scene& scene, int frame);

/// How long the clouds' clock takes from a season's first day to its last: where days pass from
/// frame to frame, frames are film.frame_seconds apart for clouds. 0 where there is no season.
double cloud_season_s(const Scene& scene);

/// The clouds' clock in a season on a day of it, `cloud_season_s` being its own.
double cloud_time_s(const Season& season, double cloud_season_s,
                    const std::vector<std::int64_t>& date);

/// An event with start and duration as its days, if it has any, have them on that clock.
CloudEvent on_clock(const Season& season, double cloud_season_s, CloudEvent event);
CloudEvent on_clock(const Scene& scene, CloudEvent event);

}  // namespace wold::scene
