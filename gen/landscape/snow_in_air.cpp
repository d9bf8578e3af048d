#include "landscape/snow_in_air.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "core/random.h"
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

/// POV-Ray ends abruptly when a ray has passed some 240 surfaces and still sees more than 1/255 of
/// what is behind. Elsewhere a ray meets few flakes, for together they have an optical depth of
/// 0.05 at most, but a whirl is dense. No flake of one is fainter than this.
constexpr float least_opacity_of_whirls = 0.15F;

/// Of flakes that are fainter than the least the share opacity over least, with the least opacity,
/// which dims as much on average; by a chance that is keyed by their place.
std::vector<snow::SeenFlake> without_faint_ones(const std::vector<snow::SeenFlake>& seen,
                                                std::uint64_t seed) {
  std::vector<snow::SeenFlake> drawn;
  drawn.reserve(seen.size());
  for (snow::SeenFlake flake : seen) {
    const auto place = std::bit_cast<std::array<std::uint32_t, 3>>(flake.centre_m);
    const std::uint64_t index = mixed((std::uint64_t{place[0]} << 32) ^ place[1]) ^ place[2];
    const double chance = random_uniform({seed, key_of("flake"), index, key_of("faint")});
    if (chance * double{least_opacity_of_whirls} >= double{flake.opacity}) continue;
    flake.opacity = std::max(flake.opacity, least_opacity_of_whirls);
    drawn.push_back(flake);
  }
  return drawn;
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
      site.snow->weather.snow_mm_h(scene::time_s(scene, frame), camera.eye_m.z);
  return snow::gunn_marshall(rate_mm_h).extinction_per_m(snow::seen_efficiency);
}

void let_it_snow(const scene::Scene& scene, const Site& site, const SnowyAir& air,
                 Landscape& landscape) {
  const Snow& snow = *site.snow;
  snow::SeenFlakes seen =
      snow::SnowInAir(scene, snow.weather, snow.pictures)
          .at(scene::time_s(scene, landscape.frame), view_of(landscape), landscape.terrain);
  landscape.flakes = with_used_pictures(snow.pictures, without_faint_ones(seen.flakes, scene.seed));
  landscape.flakes.radiance = air.radiance();
  landscape.fog = Fog{seen.fog_extinction_per_m, air.radiance()};
  show_through(air, *landscape.fog, landscape);
}

}  // namespace wold::landscape
