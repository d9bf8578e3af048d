#include "sky/exposure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/angle.h"
#include "core/colour.h"
#include "core/elementary.h"

namespace wold::sky {
namespace {

/// How a white card in the open is exposed: above white where the subject is dark, as grass and sky
/// are, and a camera that meters them opens by most of a stop. Clouds are white cards themselves,
/// and snow is one that lies in the open.
double card_exposure(Subject subject) {
  switch (subject) {
    case Subject::meadow:
      return 1.6;
    case Subject::clouds:
      return 1.2;
    case Subject::snow:
      break;
  }
  return 0.95;
}

/// Exposure of the sky at 20 degrees of elevation at which it is about to burn out: there the
/// camera stops opening. A low sun lights the sky more than the ground.
constexpr double brightest_sky = 0.9;

/// Mean radiance of a sky with clouds in the light of a low sun, over the irradiance of what faces
/// the sun at their height: they have more of it than the ground.
constexpr double lit_clouds = 0.15, cloud_height_m = 1500.0;

/// Of a level plane by sun and clear sky, as measured: 0.8 klx + 15.5 klx sin^0.5 and 128 klx
/// exp(-0.21 / sin) sin.
double clear_illuminance_klx(double sun_elevation_deg) {
  const double sine = math::sin(glm::radians(sun_elevation_deg));
  return 0.8 + 15.5 * std::sqrt(sine) + 128.0 * math::exp(-0.21 / sine) * sine;
}

}  // namespace

double metered_gain(const light::Daylight& day, Subject subject) {
  constexpr double elevation_rad = radians(20.0);
  double sky = luminance(day.mean_sky_radiance(elevation_rad));
  if (subject == Subject::clouds)
    sky = std::max(sky, lit_clouds * luminance(day.sun_irradiance_at(cloud_height_m)));
  return std::min(card_exposure(subject) * std::numbers::pi, brightest_sky / sky);
}

double dusk_gain(double sun_elevation_deg, double highest_deg) {
  return std::sqrt(clear_illuminance_klx(sun_elevation_deg) / clear_illuminance_klx(highest_deg));
}

double snow_gain(const light::Daylight& day, const ColourMap& light) {
  constexpr double brightest_snow = 0.95, fresh_albedo = 0.95, burning_fraction = 0.05;
  std::vector<float> luminances;
  luminances.reserve(light.values().size());
  for (const glm::vec3& value : light.values()) luminances.push_back(luminance(value));
  const auto limit =
      luminances.begin() +
      static_cast<std::ptrdiff_t>(burning_fraction * static_cast<double>(luminances.size()));
  std::nth_element(luminances.begin(), limit, luminances.end(), std::greater<>());
  return std::min(metered_gain(day, Subject::snow),
                  brightest_snow * std::numbers::pi / (fresh_albedo * double{*limit}));
}

}  // namespace wold::sky
