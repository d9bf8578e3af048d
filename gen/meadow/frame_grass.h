#pragma once

#include "meadow/wind_lean.h"
#include "phenology/film_season.h"
#include "place/site.h"
#include "scene/scene.h"
#include "snow/weather.h"

namespace wold::meadow {

/// What all the grass of a frame has in common. It is made once per frame, and passed on.
struct FrameGrass {
  int frame;  ///< from 1
  WindLean wind_lean;
  double snow;   ///< canopy_snow()
  double light;  ///< light_of_frame()
};

/// In a frame (from 1). Throws InputError when the scene has no such frame.
FrameGrass frame_grass(const scene::Scene& scene, const place::Site& site, int frame);

/// The same without the wind of the moment, for what needs no lean: `season` is the scene's,
/// nullptr of one that is none, `weather` that of the film.
FrameGrass still_grass(const scene::Scene& scene, const phenology::FilmSeason* season,
                       const snow::Weather& weather, int frame);

}  // namespace wold::meadow
