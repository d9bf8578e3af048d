#include "sky/precipitation.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "place/nearby_frames.h"
#include "place/view.h"
#include "scene/winter.h"
#include "sky/subpixel_flakes.h"
#include "snow/falling_snow.h"
#include "snow/raindrops.h"
#include "snow/snowfall_model.h"

namespace wold::sky {
namespace {

snow::SnowView view_of(const landscape::Landscape& landscape) {
  const landscape::Camera& camera = landscape.camera;
  return {camera.eye_m, camera.target_m, camera.field_of_view_deg, landscape.width_px,
          landscape.height_px};
}

/// The pictures that flakes use, in order, and the flakes with indices into these.
landscape::Flakes with_used_pictures(const snow::FlakePictures& pictures,
                                     const std::vector<snow::SeenFlake>& seen) {
  landscape::Flakes result;
  std::vector<int> place(pictures.all().size(), -1);
  for (const snow::SeenFlake& flake : seen) place[static_cast<std::size_t>(flake.picture)] = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] < 0) continue;
    place[i] = static_cast<int>(result.pictures.size());
    result.pictures.push_back({pictures.all()[i].name, pictures.all()[i].opacity});
  }
  result.flakes.reserve(seen.size());
  for (const snow::SeenFlake& flake : seen)
    result.flakes.push_back({flake.centre_m, flake.right_m, flake.up_m,
                             place[static_cast<std::size_t>(flake.picture)], flake.opacity});
  return result;
}

/// Flakes and drops, from the farthest to the nearest.
snow::SeenFlakes together(snow::SeenFlakes flakes, const snow::SeenFlakes& drops,
                          const glm::dvec3& eye_m) {
  const auto farther = [&](const snow::SeenFlake& a, const snow::SeenFlake& b) {
    return glm::distance(glm::dvec3(a.centre_m), eye_m) >
           glm::distance(glm::dvec3(b.centre_m), eye_m);
  };
  std::vector<snow::SeenFlake> all;
  all.reserve(flakes.flakes.size() + drops.flakes.size());
  std::ranges::merge(flakes.flakes, drops.flakes, std::back_inserter(all), farther);
  return {std::move(all), flakes.fog_extinction_per_m + drops.fog_extinction_per_m};
}

}  // namespace

double falling_extinction_per_m(const scene::Scene& scene, const place::Site& site, int frame) {
  if (!site.snow) return 0.0;
  const landscape::Camera camera = place::camera_of_frame(scene, site.terrain, frame);
  const snow::Weather& weather = *site.weather;
  const double time_s = scene::time_s(scene, frame);
  const double snow_mm_h = weather.falling_snow_mm_h(time_s, camera.eye_m.z);
  const double rain_mm_h = weather.falling_rain_mm_h(time_s, camera.eye_m.z);
  return snow::gunn_marshall(snow_mm_h).extinction_per_m(snow::seen_efficiency) +
         snow::rain_extinction_per_m(rain_mm_h, snow::seen_efficiency);
}

double overcast_extinction_per_m(const scene::Scene& scene, const place::Site& site, int frame) {
  return place::mean_of_nearby(
      scene, frame, [&](int near) { return falling_extinction_per_m(scene, site, near); });
}

void add_precipitation(const scene::Scene& scene, const place::Site& site,
                       const PrecipitationMedium& air, const landscape::Needs& needs,
                       landscape::Landscape& landscape) {
  const place::Snow& snow = *site.snow;
  const snow::SnowView view = view_of(landscape);
  const double time_s = scene::time_s(scene, landscape.frame);
  snow::SeenFlakes seen =
      together(snow::SnowfallModel(scene, *site.weather, snow.pictures, site.air)
                   .at(time_s, view, landscape.terrain),
               snow::FallingSnow(scene, *site.weather, snow.pictures, snow::Falling::rain, site.air)
                   .at(time_s, view, landscape.terrain),
               view.eye_m);
  landscape.flakes = with_used_pictures(
      snow.pictures, without_subpixel_flakes(std::move(seen.flakes), snow::Frustum(view),
                                             scene.seed, needs.max_flakes_on_a_ray));
  landscape.flakes.radiance = air.radiance();
  const landscape::Fog fog{seen.fog_extinction_per_m, air.radiance()};
  if (fog.extinction_per_m > 0.0) landscape.fog = fog;
  show_through(air, fog, landscape);
}

}  // namespace wold::sky
