#include "meadow/frame_grass.h"

#include <fmt/format.h>

#include "core/error.h"
#include "meadow/canopy_snow.h"
#include "meadow/film_lights.h"
#include "scene/calendar.h"

namespace wold::meadow {
namespace {

void check_frame(const scene::Scene& scene, int frame) {
  const std::size_t frames = scene.ageing.frames.size();
  if (frame < 1 || static_cast<std::size_t>(frame) > frames)
    throw InputError(fmt::format("frame {} does not exist: the scene has {}", frame, frames));
}

/// The wind of a season's week before a frame has combed the grass; that of [wind] otherwise.
phenology::WindChange week_before(const scene::Scene& scene, const phenology::FilmSeason* season,
                                  int frame) {
  if (season == nullptr) return {};
  return season->week_of_wind(scene::season_days(scene.season, frame));
}

}  // namespace

FrameGrass frame_grass(const scene::Scene& scene, const phenology::FilmSeason* season,
                       const snow::Weather& weather, int frame) {
  check_frame(scene, frame);
  return {frame, WindLean(scene.wind, week_before(scene, season, frame), scene.seed),
          canopy_snow(scene, weather, frame), light_of_frame(scene, frame)};
}

FrameGrass frame_grass(const scene::Scene& scene, const place::Site& site, int frame) {
  return frame_grass(scene, site.season.get(), *site.weather, frame);
}

}  // namespace wold::meadow
