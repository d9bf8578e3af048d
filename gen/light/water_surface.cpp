#include "light/water_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold::light {
namespace {

/// Even a mirror's facets are not all alike: the sun's image has a size.
constexpr double least_variance = 2e-5;

}  // namespace

double water_reflectance(double cosine) {
  const double c = std::clamp(cosine, 0.0, 1.0);
  const double inside =
      std::sqrt(1.0 - (1.0 - c * c) / (water_refractive_index * water_refractive_index));
  const double across =
      (c - water_refractive_index * inside) / (c + water_refractive_index * inside);
  const double along =
      (inside - water_refractive_index * c) / (inside + water_refractive_index * c);
  return 0.5 * (across * across + along * along);
}

SlopeVariance slope_variance(double wind_m_s) {
  return {0.00316 * wind_m_s, 0.003 + 0.00192 * wind_m_s};
}

double WaterFacets::deviation(const glm::dvec2& along) const {
  const double cosine = glm::dot(along, heading_);
  return std::sqrt(std::lerp(variance_.across, variance_.along, cosine * cosine));
}

double WaterFacets::density(const glm::dvec2& slope) const {
  const double along = glm::dot(slope, heading_);
  const double across = heading_.x * slope.y - heading_.y * slope.x;
  const double by_along = variance_.along + least_variance;
  const double by_across = variance_.across + least_variance;
  return math::exp(-0.5 * (along * along / by_along + across * across / by_across)) /
         (2.0 * std::numbers::pi * std::sqrt(by_along * by_across));
}

/// Smith's Lambda: hidden over seen, of facets that face that way.
double WaterFacets::hidden(const glm::dvec3& direction) const {
  const glm::dvec2 level(direction);
  const double length = glm::length(level);
  if (length < 1e-9) return 0.0;
  const double slope = deviation(level / length) + std::sqrt(least_variance);
  const double steepness = direction.z / (length * std::numbers::sqrt2 * slope);
  return 0.5 * (math::exp(-steepness * steepness) /
                    (std::max(steepness, 1e-6) * std::sqrt(std::numbers::pi)) -
                math::erfc(steepness));
}

double WaterFacets::glitter(const glm::dvec3& to_eye, const glm::dvec3& to_sun,
                            const glm::dvec2& tilt) const {
  if (to_sun.z <= 0.0 || to_eye.z <= 0.0) return 0.0;
  const glm::dvec3 up = glm::normalize(to_eye + to_sun);
  const glm::dvec2 slope = -glm::dvec2(up) / up.z;
  const double seen = 1.0 / (1.0 + hidden(to_eye) + hidden(to_sun));
  return water_reflectance(glm::dot(up, to_eye)) * density(slope - tilt) * seen /
         (4.0 * to_eye.z * up.z * up.z * up.z * up.z);
}

}  // namespace wold::light
