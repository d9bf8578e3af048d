#include "place/wind_at.h"

#include "phenology/film_season.h"
#include "place/air.h"
#include "terrain/ground.h"

namespace wold::place {

std::vector<glm::dvec3> wind_at(const scene::Scene& scene, std::span<const WindPoint> points) {
  const auto season = phenology::film_season(scene);
  const scene::Scene film = phenology::as_film(scene, season.get());
  const snow::Weather weather(film, season.get());
  const auto air = air_flow(film, terrain::make_ground(film.terrain, film.seed).heights_m);
  std::vector<glm::dvec3> velocities_m_s;
  for (const WindPoint& point : points)
    velocities_m_s.push_back(
        air->velocity_m_s(point.place_m, point.height_m, mean_wind(weather, point.time_s)));
  return velocities_m_s;
}

}  // namespace wold::place
