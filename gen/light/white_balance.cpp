#include "light/white_balance.h"

#include <algorithm>

#include "core/colour.h"
#include "core/elementary.h"

namespace wold::light {
namespace {

constexpr double bluest_white_K = 7000.0;

/// CIE x of daylight, a cubic of 1000 K over the temperature.
double daylight_x(double temperature_K) {
  const double t = 1000.0 / temperature_K;
  return temperature_K <= 7000.0 ? 0.244063 + t * (0.09911 + t * (2.9678 - t * 4.6070))
                                 : 0.237040 + t * (0.24748 + t * (1.9018 - t * 2.0064));
}

}  // namespace

double colour_temperature_K(const glm::dvec3& rgb) {
  const glm::dvec3 xyz = xyz_from_srgb(rgb);
  const double sum = xyz.x + xyz.y + xyz.z;
  const double n = (xyz.x / sum - 0.3366) / (xyz.y / sum - 0.1735);
  return -949.86315 + 6253.80338 * math::exp(-n / 0.92159) + 28.70599 * math::exp(-n / 0.20039) +
         0.00004 * math::exp(-n / 0.07125);
}

glm::dvec3 daylight_colour(double temperature_K) {
  const double x = daylight_x(std::clamp(temperature_K, 4000.0, 25000.0));
  const double y = x * (2.870 - 3.000 * x) - 0.275;
  return srgb_from_xyz(glm::dvec3(x / y, 1.0, (1.0 - x - y) / y));
}

glm::dvec3 camera_white(const glm::dvec3& light) {
  const double temperature_K = colour_temperature_K(light);
  if (!(temperature_K > bluest_white_K)) return light;
  const glm::dvec3 shown = daylight_colour(temperature_K) / daylight_colour(bluest_white_K);
  return light / shown * luminance(shown);
}

}  // namespace wold::light
