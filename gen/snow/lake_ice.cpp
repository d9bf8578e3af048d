#include "snow/lake_ice.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace wold::snow {
namespace {

constexpr double day_s = 86400.0;

/// Of the water's uppermost layer, and of the ice on it.
struct LakeState {
  double water_c;
  double ice_m = 0.0;

  void pass(double air_c, double days) {
    constexpr double lag_days = 20.0;
    constexpr double growth_m2_per_k_day = 1.24e-3, melt_m_per_k_day = 0.005;
    if (ice_m <= 0.0) {
      water_c += (air_c - water_c) * (1.0 - math::exp(-days / lag_days));
      if (water_c > 0.0) return;
      water_c = 0.0;
    }
    ice_m = air_c < 0.0 ? std::sqrt(ice_m * ice_m - growth_m2_per_k_day * air_c * days)
                        : std::max(ice_m - melt_m_per_k_day * air_c * days, 0.0);
  }
};

}  // namespace

double lake_ice_m(const Weather& weather, double time_s, double height_m) {
  constexpr double step_s = day_s / 4.0;
  const auto air_c = [&](double at_s) {
    return weather.at(at_s).temperature_c - lapse_k_per_m * height_m;
  };
  const double begin_s = -weather.earlier_s();
  LakeState lake{std::max(air_c(begin_s), 0.0)};
  for (double at_s = begin_s; at_s < time_s; at_s += step_s) {
    const double passed_s = std::min(step_s, time_s - at_s);
    lake.pass(air_c(at_s + 0.5 * passed_s), passed_s / day_s);
  }
  return lake.ice_m;
}

}  // namespace wold::snow
