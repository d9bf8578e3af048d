#include "place/air.h"

#include "core/random.h"
#include "scene/species.h"

namespace wold::place {
namespace {

std::shared_ptr<const wind::AirFlow> air_over(double canopy_m, const scene::Scene& scene,
                                              const Heightfield& terrain) {
  const bool steady = scene.wind.field == scene::WindPattern::steady;
  return std::make_shared<const wind::AirFlow>(
      terrain, canopy_m, steady ? 0.0 : scene.wind.turbulence,
      random_bits({scene.seed, key_of("wind"), 0, key_of("air")}));
}

}  // namespace

bool grass_waves(const scene::Scene& scene) {
  return scene.wind.grass == scene::GrassMotion::waving && !scene::has_hair(scene);
}

std::shared_ptr<const wind::AirFlow> air_flow(const scene::Scene& scene,
                                              const Heightfield& terrain) {
  return air_over(scene::mean_grass(scene).height_m, scene, terrain);
}

std::shared_ptr<const wind::AirFlow> air_over_snow(const scene::Scene& scene,
                                                   const Heightfield& terrain) {
  constexpr double snow_m = 0.01;  // of a roughness length of 1.2 mm
  return air_over(snow_m, scene, terrain);
}

wind::Moment mean_wind(const snow::Weather& weather, double time_s) {
  const snow::WeatherMoment now = weather.at(time_s);
  return {now.wind_speed_m_s, now.wind_heading_deg, weather.wind_run_m(time_s)};
}

}  // namespace wold::place
