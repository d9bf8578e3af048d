#pragma once

#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "landscape/landscape.h"
#include "light/daylight.h"

namespace wold::sky {

/// Air full of falling snow, the overcast sky it falls from, and their light.
///
/// Snow of one extinction fills the air up to 3 km, where its clouds are. Of the light from above,
/// sun and sky, the fraction exp(-tau / sine of the elevation) comes straight through; the rest
/// comes as from an overcast sky, three times as bright overhead as at the horizon (CIE S 011:2003,
/// type 1), over dark ground. What the ground sends back the snow sends down again: the air glows
/// like the mean of all directions.
class PrecipitationMedium {
 public:
  /// `day` has to outlive it. Extinction >= 0, of the snow as it is seen; `ground_albedo` in
  /// [0, 1], the mean around.
  PrecipitationMedium(const light::Daylight& day, double extinction_per_m, double ground_albedo);

  /// Fraction of the sun's own light that still arrives, in [0, 1].
  double sunlit_fraction() const;

  /// The light on the ground: what of `light` still arrives, and that of the overcast sky, of which
  /// places have the fraction `overcast`, GroundLight's, on the same grid.
  ColourMap light(const ColourMap& light, const FactorMap& overcast) const;

  /// Radiance in a unit direction of a sky that would send `clear`.
  glm::vec3 sky_radiance(const glm::vec3& clear, const glm::dvec3& direction) const;

  /// What a medium of that extinction adds; flakes send as much.
  const glm::vec3& radiance() const { return radiance_; }

 private:
  double through(double sine) const;

  const light::Daylight& day_;
  double optical_depth_;
  glm::vec3 irradiance_;  ///< of level ground by the overcast sky
  glm::vec3 radiance_;
  glm::vec3 zenith_;
};

/// Shows the sky through falling snow: its whole sphere, and its backdrop so that the fog between
/// camera and backdrop leaves what sky_radiance() says. Where hardly anything comes through the
/// fog, its own radiance is seen.
void show_through(const PrecipitationMedium& air, const landscape::Fog& fog,
                  landscape::Landscape& landscape);

}  // namespace wold::sky
