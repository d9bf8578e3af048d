#include "sky/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/angle.h"
#include "core/colour.h"
#include "core/elementary.h"
#include "core/pinhole.h"
#include "terrain/horizon.h"

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

/// Of a level plane under a clear sky, as measured: cubics of its logarithm in lux by the sun's
/// elevation over 90 degrees, each from an elevation up.
double clear_illuminance_klx(double sun_elevation_deg) {
  struct Cubic {
    double from_deg;
    std::array<double, 4> log10_lx;
  };
  constexpr std::array<Cubic, 4> cubics = {{{20.0, {3.74, 3.97, -4.07, 1.47}},
                                            {5.0, {3.05, 13.28, -45.98, 64.33}},
                                            {-0.8, {2.88, 22.26, -207.64, 1034.30}},
                                            {-5.0, {2.88, 21.81, -258.11, -858.36}}}};
  const double x = sun_elevation_deg / 90.0;
  const auto& [from_deg, c] = *std::ranges::find_if(
      cubics.begin(), cubics.end() - 1,
      [&](const Cubic& cubic) { return sun_elevation_deg >= cubic.from_deg; });
  return math::pow(10.0, c[0] + x * (c[1] + x * (c[2] + x * c[3])) - 3.0);
}

/// How bright what is dim is shown: the key of Krawczyk's tone mapping, of a fifth of the light.
double key_of(double klx) {
  const double cd_m2 = 1000.0 * klx * 0.2 / std::numbers::pi;
  return 1.03 - 2.0 / (2.0 + math::log10(cd_m2 + 1.0));
}

/// Unit vectors to places all over a camera's picture.
std::vector<glm::dvec3> lines_of_sight(const landscape::Camera& camera, double height_over_width) {
  constexpr int columns = 64, rows = 36;
  const CameraAxes axes(camera.eye_m, camera.target_m);
  const double half = half_width(camera.field_of_view_deg);
  std::vector<glm::dvec3> directions;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const double right = half * (2.0 * (x + 0.5) / columns - 1.0);
      const double up = half * height_over_width * (1.0 - 2.0 * (y + 0.5) / rows);
      directions.push_back(glm::normalize(axes.forward + axes.right * right + axes.up * up));
    }
  return directions;
}

/// The value that is met or passed by that fraction of the values.
float passed_by(double fraction, std::vector<float>& values) {
  const auto limit =
      values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size()));
  std::nth_element(values.begin(), limit, values.end(), std::greater<>());
  return *limit;
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
  const double sunset_klx = clear_illuminance_klx(0.0);
  const double klx = clear_illuminance_klx(sun_elevation_deg);
  const double brightest_klx = std::max(clear_illuminance_klx(highest_deg), sunset_klx);
  return std::sqrt(std::max(klx, sunset_klx) / brightest_klx) * key_of(std::min(klx, sunset_klx)) /
         key_of(sunset_klx);
}

double sunward_gain(const light::Daylight& day, const Heightfield& terrain,
                    const landscape::Camera& camera, double height_over_width, double gain) {
  constexpr double burning_fraction = 0.05, burning = 1.2, darkest = 0.25;
  std::vector<float> exposed;
  for (const glm::dvec3& to : lines_of_sight(camera, height_over_width)) {
    const float sky =
        to.z > 0.0 ? static_cast<float>(gain) * luminance(day.sky_radiance(to)) : 0.0F;
    const bool seen =
        sky > burning &&
        !terrain::is_hidden(terrain, camera.eye_m, camera.eye_m + to * (2.0 * terrain.size_m()));
    exposed.push_back(seen ? sky : 0.0F);
  }
  const double limit = passed_by(burning_fraction, exposed);
  return limit > burning ? std::max(burning / limit, darkest) : 1.0;
}

double snow_gain(const light::Daylight& day, const ColourMap& light) {
  constexpr double brightest_snow = 0.95, fresh_albedo = 0.95, burning_fraction = 0.05;
  std::vector<float> luminances;
  luminances.reserve(light.values().size());
  for (const glm::vec3& value : light.values()) luminances.push_back(luminance(value));
  return std::min(metered_gain(day, Subject::snow),
                  brightest_snow * std::numbers::pi /
                      (fresh_albedo * double{passed_by(burning_fraction, luminances)}));
}

}  // namespace wold::sky
