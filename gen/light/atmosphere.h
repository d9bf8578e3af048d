#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace wold::light {

/// Illuminance in klx, as linear sRGB, of a plane that faces the sun at a height above the sea, in
/// metres. Where the horizon hides a part of the sun's disc the rest of it shines; 0 where it hides
/// all. sun_elevation_rad in [-pi/2, pi/2], of the disc's middle; turbidity as Air's.
glm::dvec3 sunlight_klx(double sun_elevation_rad, double turbidity, double height_m = 0.0);

/// The clear sky over sea level and the sun through it, from dusk to noon, by scattering in a round
/// earth's air (air.h).
///
/// Light that was scattered once is summed along lines of sight by wavelength. What aerosol sends
/// nearly straight on counts as light of a wider sun, which is scattered by wider lobes (after
/// Nakajima and Tanaka 1988). What else was scattered more often comes to every place from all
/// sides alike (Hillaire 2020, A scalable and production ready sky and atmosphere rendering
/// technique, section 5.5). Tabulated for one height of the sun: what lines of sight gain, without
/// the phase functions, which hardly changes from one to the next. Colours are linear sRGB;
/// luminances may leave the gamut. Refraction bends the sun's light, not lines of sight.
class Atmosphere {
 public:
  /// sun_elevation_rad from -10 to 90 degrees, as it is seen from the ground, below the horizon as
  /// AirColumns has it; turbidity as Air's.
  Atmosphere(double sun_elevation_rad, double turbidity);

  /// sunlight_klx() of its sun at a height above the sea, in metres.
  glm::dvec3 sun_klx(double height_m = 0.0) const {
    return sunlight_klx(sun_elevation_rad_, turbidity_, height_m);
  }

  /// Luminance in kcd/m2 from an elevation in [0, pi/2], at `from_sun_rad` in [0, pi] of azimuth
  /// from the sun. `cosine`: of the angle between that direction and the sun.
  glm::dvec3 sky_kcd_m2(double elevation_rad, double from_sun_rad, double cosine) const;

 private:
  /// What a line of sight gains from each kind of scattering.
  struct Gained {
    glm::dvec3 molecules{0.0}, aerosol{0.0}, aerosol_again{0.0}, often{0.0};
  };
  std::vector<Gained> gained_;  ///< azimuths of one elevation after the other
  double sun_elevation_rad_;
  double turbidity_;
};

}  // namespace wold::light
