#include "meadow/film_lights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/elementary.h"
#include "place/view.h"
#include "scene/sun_path.h"
#include "scene/winter.h"
#include "sky/precipitation.h"

namespace wold::meadow {
namespace {

/// Mean albedo of a snowy meadow's ground: what the lighting of single frames is near to.
constexpr double mean_ground_albedo = 0.5;

/// Of level ground.
glm::vec3 irradiance(const grass::Lighting& lighting) {
  glm::vec3 sum = lighting.sun_irradiance * static_cast<float>(lighting.sun_direction.z);
  for (const grass::SkyDirection& sky : grass::sky_directions(lighting))
    sum += sky.irradiance() * static_cast<float>(sky.direction.z);
  return sum;
}

void divide(grass::Lighting& lighting, const glm::vec3& unit) {
  lighting.sun_irradiance /= unit;
  for (glm::vec3& radiance : lighting.sky_radiance) radiance /= unit;
}

/// Adds `fraction` of the lighting under falling snow.
void add(grass::Lighting& sum, const light::Daylight& day, const sky::PrecipitationMedium& air,
         float fraction) {
  sum.sun_irradiance += day.sun_irradiance() * static_cast<float>(air.sunlit_fraction()) * fraction;
  const std::vector<grass::SkyDirection> directions = grass::sky_directions(sum);
  const std::vector<glm::vec3> clear = grass::mean_sky(day);
  for (std::size_t i = 0; i < directions.size(); ++i)
    sum.sky_radiance[i] += air.sky_radiance(clear[i], directions[i].direction) * fraction;
}

/// How much each frame, from 1, counts for the light at a place among `lights`; sums to 1. Those
/// within one light's distance count, or within one frame's where frames are farther apart.
std::vector<float> frame_weights(const scene::Scene& scene, int lights, double light) {
  const auto frames = static_cast<int>(scene.ageing.frames.size());
  const double reach = std::max(1.0, (lights - 1.0) / std::max(1, frames - 1));
  std::vector<float> weights;
  for (int frame = 1; frame <= frames; ++frame) {
    const double distance = std::abs(place::time_of_frame(scene, frame) * (lights - 1) - light);
    weights.push_back(static_cast<float>(std::max(0.0, 1.0 - distance / reach)));
  }
  const float sum = std::accumulate(weights.begin(), weights.end(), 0.0F);
  for (float& weight : weights) weight /= sum;
  return weights;
}

/// The light at a place among light_count(), made such that level ground has the irradiance 1: how
/// bright and of what colour it is, the light of the ground says.
grass::Lighting lighting_at(const scene::Scene& scene, const place::Site& site, double light) {
  const int lights = light_count(scene);
  const light::Daylight day =
      lights > 1 ? light::Daylight(scene::sun_at(scene, light / (lights - 1)), scene.sky)
                 : site.day;
  const auto& soil = scene.terrain.ground_albedo;
  grass::Lighting lighting = grass::make_lighting(
      day, place::film_eye_direction(scene, site.terrain), glm::vec3(soil[0], soil[1], soil[2]));
  if (!scene::may_snow(scene)) {
    divide(lighting, day.level_irradiance());
    return lighting;
  }
  lighting.sun_irradiance = glm::vec3(0.0F);
  lighting.sky_radiance.assign(grass::sky_size(), glm::vec3(0.0F));
  const std::vector<float> weights = frame_weights(scene, lights, light);
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] > 0.0F)
      add(lighting, day,
          sky::PrecipitationMedium(
              day, sky::falling_extinction_per_m(scene, site, static_cast<int>(i) + 1),
              mean_ground_albedo),
          weights[i]);
  divide(lighting, irradiance(lighting));
  return lighting;
}

/// How far apart the lights may be: light changes fast when the sun sets.
double max_step_deg(double lowest_sun_deg) { return lowest_sun_deg < 0.0 ? 4.0 : 10.0; }

/// Into how many steps the sun's way, up and down, is cut: by height in a season, whose hour of the
/// day hardly changes.
int sun_steps(const scene::Scene& scene) {
  constexpr int places = 32;
  double min_deg = 90.0, climb_deg = 0.0, turn_deg = 0.0;
  scene::Sun before = scene::sun_at(scene, 0.0);
  for (int place = 0; place <= places; ++place) {
    const scene::Sun sun = scene::sun_at(scene, static_cast<double>(place) / places);
    min_deg = std::min(min_deg, sun.elevation_deg);
    climb_deg += std::abs(sun.elevation_deg - before.elevation_deg);
    turn_deg +=
        std::abs(sun.azimuth_deg - before.azimuth_deg) * math::cos(glm::radians(sun.elevation_deg));
    before = sun;
  }
  const double way_deg = scene::is_season(scene) ? climb_deg : math::hypot(climb_deg, turn_deg);
  return static_cast<int>(std::ceil(way_deg / max_step_deg(min_deg)));
}

}  // namespace

int light_count(const scene::Scene& scene) {
  if (!scene::sun_moves(scene)) return 1;
  return 1 + sun_steps(scene);
}

double light_of_frame(const scene::Scene& scene, int frame) {
  return place::time_of_frame(scene, frame) * (light_count(scene) - 1);
}

std::vector<grass::Lighting> film_lights(const scene::Scene& scene, const place::Site& site) {
  const int count = light_count(scene);
  std::vector<grass::Lighting> lights;
  lights.reserve(static_cast<std::size_t>(count));
  for (int light = 0; light < count; ++light) lights.push_back(lighting_at(scene, site, light));
  return lights;
}

grass::Lighting frame_lighting(const scene::Scene& scene, const place::Site& site, int frame) {
  return lighting_at(scene, site, light_of_frame(scene, frame));
}

}  // namespace wold::meadow
