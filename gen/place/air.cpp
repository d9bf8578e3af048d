#include "place/air.h"

#include "core/random.h"
#include "scene/species.h"

namespace wold::place {

bool grass_waves(const scene::Scene& scene) {
  return scene.wind.grass == scene::GrassMotion::waving && !scene::has_hair(scene);
}

std::shared_ptr<const wind::AirFlow> air_flow(const scene::Scene& scene,
                                              const Heightfield& terrain) {
  const bool steady = scene.wind.field == scene::WindPattern::steady;
  return std::make_shared<const wind::AirFlow>(
      terrain, scene::mean_grass(scene).height_m, steady ? 0.0 : scene.wind.turbulence,
      random_bits({scene.seed, key_of("wind"), 0, key_of("air")}));
}

wind::Moment mean_wind(const snow::Weather& weather, double time_s) {
  const snow::WeatherMoment now = weather.at(time_s);
  return {now.wind_speed_m_s, now.wind_heading_deg, weather.wind_run_m(time_s)};
}

}  // namespace wold::place
