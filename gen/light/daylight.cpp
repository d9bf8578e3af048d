#include "light/daylight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/error.h"
#include "core/parallel.h"
#include "light/sunlight.h"
#include "scene/sun_position.h"

namespace wold::light {
namespace {

using std::numbers::pi;

/// Perez' distribution (Perez, Seals and Michalsky 1993): zenith angle by its cosine, angle to the
/// sun in radians.
double perez(const std::array<double, 5>& shape, double cos_zenith, double from_sun_rad) {
  const auto& [a, b, c, d, e] = shape;
  const double cos_from_sun = math::cos(from_sun_rad);
  return (1.0 + a * math::exp(b / std::max(cos_zenith, 1e-3))) *
         (1.0 + c * math::exp(d * from_sun_rad) + e * cos_from_sun * cos_from_sun);
}

/// Zenith luminance in kcd/m2 (Preetham 1999, appendix A.2).
double zenith_luminance(double t, double sun_zenith_rad) {
  const double chi = (4.0 / 9.0 - t / 120.0) * (pi - 2.0 * sun_zenith_rad);
  return (4.0453 * t - 4.9710) * math::tan(chi) - 0.2155 * t + 2.4192;
}

double zenith_x(double t, double s) {
  return ((0.00166 * s - 0.00375) * s + 0.00209) * s * t * t +
         (((-0.02903 * s + 0.06377) * s - 0.03202) * s + 0.00394) * t +
         ((0.11693 * s - 0.21196) * s + 0.06052) * s + 0.25886;
}

double zenith_y(double t, double s) {
  return ((0.00275 * s - 0.00610) * s + 0.00317) * s * t * t +
         (((-0.04214 * s + 0.08970) * s - 0.04153) * s + 0.00516) * t +
         ((0.15346 * s - 0.26756) * s + 0.06670) * s + 0.26688;
}

void check(const scene::SunPosition& sun, const scene::Sky& sky) {
  if (!(sun.elevation_deg > 0.0 && sun.elevation_deg <= 90.0))
    throw InputError(fmt::format(
        "the sun's elevation is {} degrees; the daylight model holds above 0 and up to 90",
        sun.elevation_deg));
  if (!(sky.turbidity >= 1.8 && sky.turbidity <= 10.0))
    throw InputError(fmt::format(
        "the sky's turbidity is {}; the daylight model holds from 1.8 to 10", sky.turbidity));
}

/// What the sun looks like in a picture: its glare in the eye and the lens, far dimmer than the
/// disc. Radiance as a multiple of the sun's irradiance.
double glare(double from_sun_rad) {
  const auto bell = [&](double width_deg) {
    const double t = from_sun_rad / (width_deg * radians_per_degree);
    return math::exp(-0.5 * t * t);
  };
  return 6.0 * bell(0.5) + 0.4 * bell(2.0);
}

/// Radiance of distant meadows under irradiance 1; their reflectance is a choice between green and
/// dry grass.
const glm::dvec3 plain_radiance = glm::dvec3(0.10, 0.11, 0.055) / pi;

/// How far the plain below the scene lies under the eye.
constexpr double plain_below_m = 60.0;

/// The whole sphere as Daylight::sky_image() has it, with radiance(direction) in its pixels.
template <class Radiance>
Image sphere_image(int width_px, const Radiance& radiance) {
  Image image(width_px, width_px / 2, 3);
  parallel_for(static_cast<std::size_t>(image.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    const double elevation_rad = pi * (0.5 - (y + 0.5) / image.height);
    for (int x = 0; x < image.width; ++x) {
      const glm::vec3 seen =
          radiance(direction_of(2.0 * pi * (x + 0.5) / image.width, elevation_rad));
      for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = seen[c];
    }
  });
  return image;
}

}  // namespace

glm::dvec3 direction_of(double azimuth_rad, double elevation_rad) {
  return {math::sin(azimuth_rad) * math::cos(elevation_rad),
          math::cos(azimuth_rad) * math::cos(elevation_rad), math::sin(elevation_rad)};
}

double haze_fraction(double distance_m, double visual_range_m) {
  return 1.0 - math::exp(-3.912 * distance_m / visual_range_m);
}

Daylight::Daylight(const scene::Sun& scene_sun, const scene::Sky& sky)
    : visual_range_m_(sky.visual_range_m) {
  const scene::SunPosition sun = scene::sun_position(scene_sun);
  check(sun, sky);
  const double t = sky.turbidity;
  const double sun_zenith_rad = (90.0 - sun.elevation_deg) * radians_per_degree;
  sun_direction_ =
      direction_of(sun.azimuth_deg * radians_per_degree, sun.elevation_deg * radians_per_degree);
  perez_[0].shape = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251,
                     0.1206 * t - 2.5771, -0.0670 * t + 0.3703};
  perez_[1].shape = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125,
                     -0.0641 * t - 0.8989, -0.0033 * t + 0.0452};
  perez_[2].shape = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102,
                     -0.0441 * t - 1.6537, -0.0109 * t + 0.0529};
  const std::array<double, 3> zenith = {zenith_luminance(t, sun_zenith_rad),
                                        zenith_x(t, sun_zenith_rad), zenith_y(t, sun_zenith_rad)};
  for (std::size_t k = 0; k < 3; ++k)
    perez_[k].scale = zenith[k] / perez(perez_[k].shape, 1.0, sun_zenith_rad);
  balance(sun.elevation_deg * radians_per_degree, t);
}

void Daylight::balance(double sun_elevation_rad, double turbidity) {
  constexpr int azimuths = 72;
  std::array<glm::dvec3, 91> mean_klx{};
  glm::dvec3 sky_klx(0.0);
  for (int degree = 0; degree <= 90; ++degree) {
    const double elevation_rad = degree * radians_per_degree;
    glm::dvec3& mean = mean_klx[static_cast<std::size_t>(degree)];
    for (int k = 0; k < azimuths; ++k)
      mean +=
          above_horizon(direction_of(2.0 * pi * k / azimuths, elevation_rad)) / (1.0 * azimuths);
    sky_klx += mean * (pi * math::sin(2.0 * elevation_rad) * radians_per_degree);
  }
  const glm::dvec3 sun_klx =
      glm::max(direct_sunlight_klx(sun_elevation_rad, turbidity), glm::dvec3(0.0));
  unit_ = sky_klx + sun_klx * sun_direction_.z;
  sun_irradiance_ = glm::vec3(sun_klx / unit_);
  sky_irradiance_ = glm::vec3(sky_klx / unit_);
  for (std::size_t degree = 0; degree < mean_klx.size(); ++degree)
    mean_by_degree_[degree] = glm::vec3(mean_klx[degree] / unit_);
}

glm::dvec3 Daylight::above_horizon(const glm::dvec3& direction) const {
  // The fit of x and y turns pink in the last degrees, which clear skies do not: there they keep
  // the colour they have at about 9 degrees.
  constexpr double lowest_coloured = 0.15;
  const double from_sun_rad =
      math::acos(std::clamp(glm::dot(direction, sun_direction_), -1.0, 1.0));
  const auto value = [&](std::size_t k, double cos_zenith) {
    return perez_[k].scale * perez(perez_[k].shape, cos_zenith, from_sun_rad);
  };
  const double coloured = std::max(direction.z, lowest_coloured);
  const glm::dvec3 rgb =
      rgb_from_xyY(value(1, coloured), value(2, coloured), value(0, direction.z));
  return glm::max(rgb, glm::dvec3(0.0));
}

glm::vec3 Daylight::sky_radiance(const glm::dvec3& direction) const {
  if (direction.z >= 0.0) return glm::vec3(above_horizon(direction) / unit_);
  const double fraction = haze_fraction(plain_below_m / -direction.z, visual_range_m_);
  return glm::mix(glm::vec3(plain_radiance), haze_radiance(direction, fraction),
                  static_cast<float>(fraction));
}

glm::vec3 Daylight::haze_radiance(const glm::dvec3& direction, double fraction) const {
  const glm::dvec3 level(direction.x, direction.y, 0.0);
  const double length = glm::length(level);
  if (length < 1e-6) return mean_by_degree_.front();
  const glm::vec3 behind(above_horizon(level / length) / unit_);
  return glm::mix(mean_by_degree_.front(), behind, static_cast<float>(fraction));
}

glm::vec3 Daylight::mean_sky_radiance(double elevation_rad) const {
  const double degree = std::clamp(elevation_rad / radians_per_degree, 0.0, 90.0);
  const auto low = static_cast<std::size_t>(std::min(degree, 89.0));
  return glm::mix(mean_by_degree_[low], mean_by_degree_[low + 1],
                  static_cast<float>(degree - static_cast<double>(low)));
}

glm::vec3 Daylight::seen_radiance(const glm::dvec3& direction) const {
  const glm::vec3 radiance = sky_radiance(direction);
  if (direction.z < 0.0) return radiance;
  const double from_sun_rad =
      math::acos(std::clamp(glm::dot(direction, sun_direction_), -1.0, 1.0));
  return radiance + sun_irradiance_ * static_cast<float>(glare(from_sun_rad));
}

Image Daylight::sky_image(int width_px) const {
  return sphere_image(width_px, [this](const glm::dvec3& to) { return seen_radiance(to); });
}

Image Daylight::sunless_sky_image(int width_px) const {
  return sphere_image(width_px, [this](const glm::dvec3& to) { return sky_radiance(to); });
}

}  // namespace wold::light
