#pragma once

#include <glm/glm.hpp>

namespace wold::light {

/// Of fresh water for visible light.
inline constexpr double water_refractive_index = 1.333;

/// Fraction of unpolarised light that smooth water reflects, by the cosine of the angle between the
/// ray and the surface's normal, in [0, 1]: Fresnel 1823.
double water_reflectance(double cosine);

/// Variance of the slopes of a wind-roughened water surface, along the wind and across it.
struct SlopeVariance {
  double along = 0.0;
  double across = 0.0;
};

/// The same for a wind in m/s at a height of 12.5 m: 0.00316 w and 0.003 + 0.00192 w, as Cox and
/// Munk 1954 measured it on the open sea from the sun's glitter [CoxMunk].
SlopeVariance slope_variance(double wind_m_s);

/// A rough water surface as one sees it: facets whose slopes are normally distributed.
class WaterFacets {
 public:
  /// `heading`: level unit vector along the wind.
  WaterFacets(const SlopeVariance& variance, const glm::dvec2& heading)
      : variance_(variance), heading_(heading) {}

  /// Standard deviation of the slopes along a level unit direction.
  double deviation(const glm::dvec2& along) const;

  /// The sun's glitter: radiance in a unit direction `to_eye` over the irradiance of a plane that
  /// faces the sun, in the unit direction `to_sun`. `tilt`: mean slope of the facets there. Facets
  /// that others hide do not count (Smith 1967 [Smith]). 0 where the sun has set.
  double glitter(const glm::dvec3& to_eye, const glm::dvec3& to_sun,
                 const glm::dvec2& tilt = glm::dvec2(0.0)) const;

 private:
  double density(const glm::dvec2& slope) const;
  double hidden(const glm::dvec3& direction) const;

  SlopeVariance variance_;
  glm::dvec2 heading_;
};

}  // namespace wold::light
