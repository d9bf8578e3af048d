#include "landscape/film_lighting.h"

#include "landscape/snow_in_air.h"
#include "landscape/view.h"
#include "scene/winter.h"

namespace wold::landscape {
namespace {

/// Mean albedo of a snowy meadow's ground: what the lighting of single frames is near to.
constexpr double mean_ground_albedo = 0.5;

/// Of level ground.
glm::vec3 irradiance(const grass::Lighting& lighting) {
  glm::vec3 sum = lighting.sun_irradiance * static_cast<float>(lighting.sun_direction.z);
  for (const grass::SkyDirection& sky : grass::sky_directions(lighting))
    sum += sky.irradiance * static_cast<float>(sky.direction.z);
  return sum;
}

/// Makes it the unit, as it is of the day: how bright the light is, the light of the ground says.
void normalise(grass::Lighting& lighting) {
  const glm::vec3 unit = irradiance(lighting);
  lighting.sun_irradiance /= unit;
  for (glm::vec3& radiance : lighting.sky_radiance) radiance /= unit;
}

/// Adds `share` of the lighting under falling snow.
void add(grass::Lighting& sum, const light::Daylight& day, const SnowyAir& air, float share) {
  sum.sun_irradiance += day.sun_irradiance() * static_cast<float>(air.sun_share()) * share;
  const auto& rings = grass::sky_rings();
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    const double elevation = rings[ring].elevation;
    sum.sky_radiance[ring] +=
        air.sky_radiance(day.mean_sky_radiance(elevation), light::direction_of(0.0, elevation)) *
        share;
  }
}

}  // namespace

grass::Lighting film_lighting(const scene::Scene& scene, const Site& site) {
  const glm::dvec3 eye = film_eye_direction(scene, site.terrain);
  grass::Lighting lighting = grass::make_lighting(site.day, eye);
  if (!scene::may_snow(scene)) return lighting;
  lighting.sun_irradiance = glm::vec3(0.0F);
  lighting.sky_radiance.assign(grass::sky_rings().size(), glm::vec3(0.0F));
  const auto frames = static_cast<int>(scene.ageing.frames.size());
  for (int frame = 1; frame <= frames; ++frame)
    add(lighting, site.day,
        SnowyAir(site.day, snow_extinction_per_m(scene, site, frame), mean_ground_albedo),
        1.0F / static_cast<float>(frames));
  normalise(lighting);
  return lighting;
}

}  // namespace wold::landscape
