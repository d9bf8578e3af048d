#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>

#include "core/image.h"
#include "light/atmosphere.h"
#include "scene/scene.h"

namespace wold::light {

/// Sun and clear sky over open, flat ground.
///
/// Both are of one Atmosphere: what its air scatters towards the eye, and what it leaves of the
/// sun.
///
/// Unit: everything is divided, channel by channel, by what the camera shows as white of the total
/// irradiance of a horizontal plane (white_balance.h). While the sun is up sun and sky together
/// give the plane (1, 1, 1). That is what a camera does that is balanced and exposed on a white
/// card lying in the open: brightness and white stay put while the sun moves; what stays is a warm
/// sun against a blue sky. At dusk the plane still has the luminance 1, but is blue: a camera's
/// balance does not follow so far. Colours are linear sRGB. Directions are world space: x east, y
/// north, z up.
class Daylight {
 public:
  /// The sun stands at scene::sun_position(), in [-10, 90] degrees of elevation; turbidity in
  /// [1.8, 10]; throws InputError otherwise.
  Daylight(const scene::Sun& sun, const scene::Sky& sky);

  /// Unit vector towards the sun.
  const glm::dvec3& sun_direction() const { return sun_direction_; }
  /// Irradiance by the sun alone on a plane that faces it.
  const glm::vec3& sun_irradiance() const { return sun_irradiance_; }
  /// Irradiance by the sun alone on a plane that faces it at a height above the sea, in metres;
  /// below the sea as at it. The lower the sun, the more of it is left up there.
  glm::vec3 sun_irradiance_at(double height_m) const;
  /// Distance at which dark things vanish in the haze, as Koschmieder's.
  double visual_range_m() const { return visual_range_m_; }
  /// Irradiance by the sky alone on a horizontal plane.
  const glm::vec3& sky_irradiance() const { return sky_irradiance_; }
  /// Irradiance by sun and sky on a horizontal plane: of luminance 1, white by day.
  const glm::vec3& level_irradiance() const { return level_irradiance_; }

  /// Radiance from a unit direction, without the sun's disc. Below the horizon: a plain of meadows
  /// that fades into the horizon's haze.
  glm::vec3 sky_radiance(const glm::dvec3& direction) const;

  /// sky_radiance() as a camera sees it: with a soft glow of limited radiance instead of the sun's
  /// disc, so that no pixel outshines the rest by orders of magnitude.
  glm::vec3 seen_radiance(const glm::dvec3& direction) const;

  /// Radiance of haze in a unit direction where it hides all; where it hides `fraction`, in [0, 1],
  /// of what is behind, that fraction of it is seen. Near haze, which hides little, has the light
  /// of all directions, distant haze that of the horizon.
  glm::vec3 haze_radiance(const glm::dvec3& direction, double fraction) const;

  /// Sky radiance averaged over azimuth, elevation in [0, pi/2] radians.
  glm::vec3 mean_sky_radiance(double elevation_rad) const;

  /// seen_radiance() of the whole sphere as a picture of width x width/2 pixels: column c looks to
  /// azimuth 360 (c + 0.5) / width degrees clockwise from north, row r to elevation 90 - 180 (r +
  /// 0.5) / height degrees.
  Image sky_image(int width_px) const;

  /// The same of sky_radiance(): the sun neither shines nor glows in it.
  Image sunless_sky_image(int width_px) const;

 private:
  glm::dvec3 above_horizon(const glm::dvec3& direction) const;
  void balance();

  std::shared_ptr<const Atmosphere> atmosphere_;
  glm::dvec3 sun_direction_;
  double visual_range_m_;
  glm::dvec3 unit_ = glm::dvec3(1.0);  ///< klx of irradiance that count as 1
  glm::vec3 sun_irradiance_;
  glm::vec3 sky_irradiance_;
  glm::vec3 level_irradiance_;
  std::array<glm::vec3, 91> mean_by_degree_;
};

/// Unit vector for an azimuth clockwise from north and an elevation.
glm::dvec3 direction_of(double azimuth_rad, double elevation_rad);

/// Fraction of what is seen at a distance, >= 0, that haze hides, in [0, 1): Koschmieder 1924, 98 %
/// at the visual range.
double haze_fraction(double distance_m, double visual_range_m);

}  // namespace wold::light
