#include "landscape/snow_in_air.h"

#include <utility>
#include <vector>

#include "landscape/faint_flakes.h"
#include "landscape/nearby_frames.h"
#include "landscape/view.h"
#include "scene/winter.h"
#include "snow/size_distribution.h"
#include "snow/snow_in_air.h"

namespace wold::landscape {
namespace {

snow::SnowView view_of(const Landscape& landscape) {
  const Camera& camera = landscape.camera;
  return {camera.eye_m, camera.target_m, camera.field_of_view_deg, landscape.width_px,
          landscape.height_px};
}

/// The pictures that flakes use, in order, and the flakes with indices into these.
Flakes with_used_pictures(const snow::FlakePictures& pictures,
                          const std::vector<snow::SeenFlake>& seen) {
  Flakes result;
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

}  // namespace

double snow_extinction_per_m(const scene::Scene& scene, const Site& site, int frame) {
  if (!site.snow) return 0.0;
  const Camera camera = resolved_camera(scene.camera, site.terrain, time_of_frame(scene, frame));
  const double rate_mm_h =
      site.snow->weather.falling_snow_mm_h(scene::time_s(scene, frame), camera.eye_m.z);
  return snow::gunn_marshall(rate_mm_h).extinction_per_m(snow::seen_efficiency);
}

double overcast_extinction_per_m(const scene::Scene& scene, const Site& site, int frame) {
  return mean_of_nearby(scene, frame,
                        [&](int near) { return snow_extinction_per_m(scene, site, near); });
}

void let_it_snow(const scene::Scene& scene, const Site& site, const SnowyAir& air,
                 Landscape& landscape) {
  const Snow& snow = *site.snow;
  const snow::SnowView view = view_of(landscape);
  snow::SeenFlakes seen = snow::SnowInAir(scene, snow.weather, snow.pictures)
                              .at(scene::time_s(scene, landscape.frame), view, landscape.terrain);
  landscape.flakes = with_used_pictures(
      snow.pictures, without_faint_flakes(std::move(seen.flakes), snow::Frustum(view), scene.seed));
  landscape.flakes.radiance = air.radiance();
  const Fog fog{seen.fog_extinction_per_m, air.radiance()};
  if (fog.extinction_per_m > 0.0) landscape.fog = fog;
  show_through(air, fog, landscape);
}

}  // namespace wold::landscape
