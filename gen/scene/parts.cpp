#include "scene/parts.h"

#include "scene/calendar.h"

namespace wold::scene {

MeadowPart::MeadowPart(const Scene& scene)
    : seed(scene.seed), grass(scene.grass), ageing(scene.ageing), species(scene.species) {
  if (!scene.shots.empty()) takes = takes_of(scene);
}

SeasonPart::SeasonPart(const Scene& scene)
    : season(scene.season),
      keys(scene.season_keys),
      weather(scene.weather),
      wind(scene.wind),
      latitude_deg(scene.sun.latitude_deg),
      visual_range_m(scene.sky.visual_range_m) {}

WeatherPart::WeatherPart(const Scene& scene)
    : weather(scene.weather),
      wind(scene.wind),
      strength(scene.snowfall.strength),
      latitude_deg(scene.sun.latitude_deg) {}

PrecipitationPart::PrecipitationPart(const Scene& scene)
    : seed(scene.seed),
      snowfall(scene.snowfall),
      rainfall(scene.rainfall),
      wind(scene.wind),
      terrain_m(scene.terrain.size_m) {}

SnowCoverPart::SnowCoverPart(const Scene& scene)
    : seed(scene.seed),
      cover(scene.snow_cover),
      earlier_h(scene.weather.earlier_h),
      film_s(scene::film_s(scene)),
      is_season(scene::is_season(scene)) {}

CloudsPart::CloudsPart(const Scene& scene)
    : seed(scene.seed),
      layers(scene.clouds),
      events(scene.cloud_events),
      season(scene.season),
      sun(scene.sun),
      turbidity(scene.sky.turbidity),
      frame_seconds(scene.film.frame_seconds),
      season_s(cloud_season_s(scene)) {}

}  // namespace wold::scene
