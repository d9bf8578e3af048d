#include "light/daylight.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/error.h"
#include "core/parallel.h"
#include "light/white_balance.h"
#include "scene/sun_position.h"

namespace wold::light {
namespace {

using std::numbers::pi;

void check(const scene::SunPosition& sun, const scene::Sky& sky) {
  if (!(sun.elevation_deg >= -10.0 && sun.elevation_deg <= 90.0))
    throw InputError(
        fmt::format("the sun's elevation is {} degrees; the daylight model holds from -10 to 90",
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

/// Of distant meadows: a choice between green and dry grass.
constexpr glm::vec3 plain_reflectance(0.10F, 0.11F, 0.055F);

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
  const double elevation_rad = radians(sun.elevation_deg);
  sun_direction_ = direction_of(radians(sun.azimuth_deg), elevation_rad);
  atmosphere_ = std::make_shared<const Atmosphere>(elevation_rad, sky.turbidity);
  balance();
}

void Daylight::balance() {
  constexpr int azimuths = 72;
  const double sun_azimuth_rad = math::atan2(sun_direction_.x, sun_direction_.y);
  std::array<glm::dvec3, 91> mean_klx{};
  glm::dvec3 sky_klx(0.0);
  for (int degree = 0; degree <= 90; ++degree) {
    const double elevation_rad = degree * radians_per_degree;
    glm::dvec3& mean = mean_klx[static_cast<std::size_t>(degree)];
    for (int k = 0; k < azimuths; ++k)  // of the half on the sun's right: the other one is like it
      mean +=
          above_horizon(direction_of(sun_azimuth_rad + pi * (k + 0.5) / azimuths, elevation_rad)) /
          (1.0 * azimuths);
    sky_klx += mean * (pi * math::sin(2.0 * elevation_rad) * radians_per_degree);
  }
  const glm::dvec3 sun_klx = glm::max(atmosphere_->sun_klx(), glm::dvec3(0.0));
  const glm::dvec3 level_klx = sky_klx + sun_klx * std::max(sun_direction_.z, 0.0);
  unit_ = camera_white(level_klx);
  level_irradiance_ = glm::vec3(level_klx / unit_);
  sun_irradiance_ = glm::vec3(sun_klx / unit_);
  sky_irradiance_ = glm::vec3(sky_klx / unit_);
  for (std::size_t degree = 0; degree < mean_klx.size(); ++degree)
    mean_by_degree_[degree] = glm::vec3(mean_klx[degree] / unit_);
}

glm::vec3 Daylight::sun_irradiance_at(double height_m) const {
  return glm::vec3(glm::max(atmosphere_->sun_klx(height_m), glm::dvec3(0.0)) / unit_);
}

glm::dvec3 Daylight::above_horizon(const glm::dvec3& direction) const {
  const double elevation_rad = math::asin(std::clamp(direction.z, 0.0, 1.0));
  const glm::dvec2 level(direction), sun_level(sun_direction_);
  const double lengths = glm::length(level) * glm::length(sun_level);
  const double from_sun_rad =
      lengths > 0.0 ? math::acos(std::clamp(glm::dot(level, sun_level) / lengths, -1.0, 1.0)) : 0.0;
  const glm::dvec3 rgb = atmosphere_->sky_kcd_m2(
      elevation_rad, from_sun_rad, std::clamp(glm::dot(direction, sun_direction_), -1.0, 1.0));
  return glm::max(rgb, glm::dvec3(0.0));
}

glm::vec3 Daylight::sky_radiance(const glm::dvec3& direction) const {
  if (direction.z >= 0.0) return glm::vec3(above_horizon(direction) / unit_);
  const double fraction = haze_fraction(plain_below_m / -direction.z, visual_range_m_);
  const glm::vec3 plain = level_irradiance_ * plain_reflectance / std::numbers::pi_v<float>;
  return glm::mix(plain, haze_radiance(direction, fraction), static_cast<float>(fraction));
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
