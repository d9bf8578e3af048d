#include "meadow/frame_grass.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "core/error.h"
#include "meadow/canopy_snow.h"
#include "meadow/film_lights.h"
#include "meadow/mean_beam.h"
#include "place/air.h"
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
  return season->week_of_wind(scene::season_days(scene, frame));
}

/// How the grass answers the wind of a frame.
std::shared_ptr<const wind::CanopyMotion> motion_in(std::shared_ptr<const wind::AirFlow> air,
                                                    const scene::Scene& scene,
                                                    const snow::Weather& weather, double snow,
                                                    int frame) {
  if (!air) return nullptr;
  const double weathering = scene.ageing.frames[static_cast<std::size_t>(frame - 1)];
  return std::make_shared<const wind::CanopyMotion>(
      std::move(air), place::mean_wind(weather, scene::time_s(scene, frame)),
      mean_beam(scene, weathering, snow), scene.grass.patch_m);
}

FrameGrass grass_in(std::shared_ptr<const wind::AirFlow> air, const scene::Scene& scene,
                    const phenology::FilmSeason* season, const snow::Weather& weather, int frame) {
  check_frame(scene, frame);
  const double snow = canopy_snow(scene, weather, frame);
  return {frame,
          WindLean(scene.wind, week_before(scene, season, frame), scene.seed,
                   motion_in(std::move(air), scene, weather, snow, frame)),
          snow, light_of_frame(scene, frame)};
}

}  // namespace

FrameGrass still_grass(const scene::Scene& scene, const phenology::FilmSeason* season,
                       const snow::Weather& weather, int frame) {
  return grass_in(nullptr, scene, season, weather, frame);
}

FrameGrass frame_grass(const scene::Scene& scene, const place::Site& site, int frame) {
  return grass_in(site.air, scene, site.season.get(), *site.weather, frame);
}

}  // namespace wold::meadow
