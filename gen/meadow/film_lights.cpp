#include "meadow/film_lights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/elementary.h"
#include "place/view.h"
#include "scene/calendar.h"
#include "scene/shots.h"
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

/// The moments that a take's grass is baked for, among those of the film.
struct TakeLights {
  scene::Take take;
  int first = 0;
  int count = 1;

  /// Where a place among the film's lights lies on the take's way, in [0, 1].
  double way(double light) const { return count < 2 ? 0.5 : (light - first) / (count - 1); }
};

/// How much each of a take's frames counts for the light at a place among its lights; sums to 1.
/// Those within one light's distance count, or within one frame's where frames are farther apart.
std::vector<float> frame_weights(const scene::Scene& scene, const TakeLights& lights,
                                 double light) {
  const double reach = std::max(1.0, (lights.count - 1.0) / std::max(1, lights.take.count - 1));
  std::vector<float> weights;
  for (int frame = lights.take.first; frame <= lights.take.last(); ++frame) {
    const double distance =
        std::abs(scene::way_of_frame(scene, frame) * (lights.count - 1) - (light - lights.first));
    weights.push_back(static_cast<float>(std::max(0.0, 1.0 - distance / reach)));
  }
  const float sum = std::accumulate(weights.begin(), weights.end(), 0.0F);
  for (float& weight : weights) weight /= sum;
  return weights;
}

/// The light at a place among a take's, made such that level ground has the irradiance 1: how
/// bright and of what colour it is, the light of the ground says.
grass::Lighting lighting_at(const scene::Scene& scene, const place::Site& site,
                            const TakeLights& lights, double light) {
  const light::Daylight day =
      scene::sun_moves(scene)
          ? light::Daylight(scene::sun_on_way(scene, lights.take, lights.way(light)), scene.sky)
          : site.day;
  const auto& soil = scene.terrain.ground_albedo;
  grass::Lighting lighting =
      grass::make_lighting(day, place::eye_direction(scene, site.terrain, lights.take),
                           glm::vec3(soil[0], soil[1], soil[2]));
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
              day,
              sky::falling_extinction_per_m(scene, site, lights.take.first + static_cast<int>(i)),
              mean_ground_albedo),
          weights[i]);
  divide(lighting, irradiance(lighting));
  return lighting;
}

/// How far apart the lights may be: light changes fast when the sun sets.
double max_step_deg(double lowest_sun_deg) { return lowest_sun_deg < 0.0 ? 4.0 : 10.0; }

/// Into how many steps the sun's way in a take, up and down, is cut: by height in a season without
/// shots, whose hour of the day hardly changes. A way of less than the sun's own radius is none.
int sun_steps(const scene::Scene& scene, const scene::Take& take) {
  constexpr int places = 32;
  constexpr double radius_deg = 0.27;
  double min_deg = 90.0, climb_deg = 0.0, turn_deg = 0.0;
  scene::Sun before = scene::sun_on_way(scene, take, 0.0);
  for (int place = 0; place <= places; ++place) {
    const scene::Sun sun = scene::sun_on_way(scene, take, static_cast<double>(place) / places);
    min_deg = std::min(min_deg, sun.elevation_deg);
    climb_deg += std::abs(sun.elevation_deg - before.elevation_deg);
    turn_deg +=
        std::abs(sun.azimuth_deg - before.azimuth_deg) * math::cos(glm::radians(sun.elevation_deg));
    before = sun;
  }
  const bool by_height = scene::is_season(scene) && scene.shots.empty();
  const double way_deg = by_height ? climb_deg : math::hypot(climb_deg, turn_deg);
  return way_deg < radius_deg ? 0 : static_cast<int>(std::ceil(way_deg / max_step_deg(min_deg)));
}

/// Whether two takes are of the same time: the sun goes the same way in both.
bool are_of_one_time(const scene::Scene& scene, const scene::Take& a, const scene::Take& b) {
  return scene::time_s(scene, a.first) == scene::time_s(scene, b.first) &&
         scene::time_s(scene, a.last()) == scene::time_s(scene, b.last());
}

/// Of each take. Where the sun stands still all have one light, and takes of one time share theirs.
std::vector<TakeLights> lights_of_takes(const scene::Scene& scene) {
  if (!scene::sun_moves(scene)) return {{scene::whole_film(scene), 0, 1}};
  std::vector<TakeLights> all;
  int next = 0;
  for (const scene::Take& take : scene::takes_of(scene)) {
    const auto same = std::ranges::find_if(
        all, [&](const TakeLights& other) { return are_of_one_time(scene, other.take, take); });
    if (same != all.end()) {
      all.push_back({take, same->first, same->count});
      continue;
    }
    all.push_back({take, next, 1 + sun_steps(scene, take)});
    next += all.back().count;
  }
  return all;
}

/// Those of a frame (from 1).
TakeLights lights_of(const scene::Scene& scene, int frame) {
  const std::vector<TakeLights> all = lights_of_takes(scene);
  const auto found = std::ranges::find_if(
      all, [&](const TakeLights& lights) { return frame <= lights.take.last(); });
  return found != all.end() ? *found : all.back();
}

double light_of_frame(const scene::Scene& scene, const TakeLights& lights, int frame) {
  return lights.first + scene::way_of_frame(scene, frame) * (lights.count - 1);
}

}  // namespace

int light_count(const scene::Scene& scene) {
  int count = 0;
  for (const TakeLights& lights : lights_of_takes(scene))
    count = std::max(count, lights.first + lights.count);
  return count;
}

double light_of_frame(const scene::Scene& scene, int frame) {
  return light_of_frame(scene, lights_of(scene, frame), frame);
}

std::vector<grass::Lighting> film_lights(const scene::Scene& scene, const place::Site& site) {
  std::vector<grass::Lighting> made;
  for (const TakeLights& lights : lights_of_takes(scene))
    for (int light = lights.first; light < lights.first + lights.count; ++light)
      if (light == static_cast<int>(made.size()))
        made.push_back(lighting_at(scene, site, lights, light));
  return made;
}

grass::Lighting frame_lighting(const scene::Scene& scene, const place::Site& site, int frame) {
  const TakeLights lights = lights_of(scene, frame);
  return lighting_at(scene, site, lights, light_of_frame(scene, lights, frame));
}

}  // namespace wold::meadow
