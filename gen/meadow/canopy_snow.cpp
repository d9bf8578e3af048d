#include "meadow/canopy_snow.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "grass/geometry/snow_ridge.h"
#include "place/site.h"
#include "scene/species.h"
#include "scene/winter.h"

namespace wold::meadow {
namespace {

constexpr double hour_s = 3600.0;
constexpr double step_s = 600.0;
constexpr double cold_hours = 60.0;
constexpr double warm_hours = 1.5;

double canopy_cover(double leaf_area_index) { return -math::expm1(-0.5 * leaf_area_index); }

/// The fraction after constant weather: it approaches where catching and unloading are in balance.
double after(double fraction, double caught_per_h, double unloaded_per_h, double hours) {
  const double rate_per_h = caught_per_h + unloaded_per_h;
  const double balance = caught_per_h / rate_per_h;
  return balance + (fraction - balance) * math::exp(-rate_per_h * hours);
}

}  // namespace

double canopy_capacity_mm(double leaf_area_index) {
  return grass::leaf_snow_kg_m2 * leaf_area_index;
}

double unloading_per_h(double temperature_c) {
  return std::lerp(1.0 / cold_hours, 1.0 / warm_hours, std::clamp(temperature_c, 0.0, 1.0));
}

double intercepted_fraction(double leaf_area_index, double fraction,
                            const std::function<CanopyWeather(double)>& weather, double from_s,
                            double to_s) {
  const double capacity_mm = canopy_capacity_mm(leaf_area_index);
  const double caught_per_mm = canopy_cover(leaf_area_index) / capacity_mm;
  double begin_s = from_s;
  while (begin_s < to_s) {
    const double end_s = std::min(begin_s + step_s, to_s);
    const CanopyWeather now = weather(0.5 * (begin_s + end_s));
    fraction = after(fraction, caught_per_mm * now.snowfall_mm_h,
                     unloading_per_h(now.temperature_c), (end_s - begin_s) / hour_s);
    begin_s = end_s;
  }
  return std::clamp(fraction, 0.0, 1.0);
}

double canopy_snow(const scene::Scene& scene, const snow::Weather& weather, int frame) {
  if (scene.snow_cover.cover != scene::CoverModel::depth || scene::has_hair(scene)) return 0.0;
  const double leaf_area = place::leaf_area_index(scene);
  const double caught_per_mm = canopy_cover(leaf_area) / canopy_capacity_mm(leaf_area);
  const double initial = -math::expm1(-caught_per_mm * scene.snow_cover.initial_mm);
  const auto on_canopy = [&](double time_s) {
    return CanopyWeather{weather.at(time_s).temperature_c, weather.snow_mm_h(time_s, 0.0)};
  };
  return intercepted_fraction(leaf_area, initial, on_canopy, -weather.earlier_s(),
                              scene::time_s(scene, frame));
}

}  // namespace wold::meadow
