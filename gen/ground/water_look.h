#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "core/image.h"
#include "core/noise.h"
#include "ground/mirrored_land.h"
#include "light/water_surface.h"
#include "snow/weather.h"
#include "terrain/water.h"

namespace wold::ground {

/// What water mirrors in one frame.
struct Mirrored {
  const MirroredLand& land;
  std::function<glm::vec3(const glm::dvec2& at_m)> land_radiance;  ///< without haze
  std::function<glm::vec3(const glm::dvec3& direction)> sky;       ///< unit direction
};

/// The sun on level water: unit vector towards it, and the irradiance by place of a plane that
/// faces it.
struct SunOnWater {
  glm::dvec3 to_sun;
  std::function<glm::vec3(const glm::dvec2& at_m)> irradiance;
};

/// What a wind makes of water: waves that a picture's steps show, and the rest of them as the
/// spread of facets.
class Waves {
 public:
  /// Waves run before the wind, so many seconds after the first frame.
  Waves(const snow::WeatherMoment& wind, double time_s, std::uint64_t seed, double step_m);

  /// Mean slope of a step's facets.
  glm::dvec2 tilt(const glm::dvec2& at_m) const;
  /// The facets' spread about it.
  const light::WaterFacets& facets() const { return facets_; }

 private:
  glm::dvec2 heading_, way_m_;
  light::SlopeVariance variance_;
  ScaleFreeNoise along_, across_;
  light::WaterFacets facets_;
};

/// Radiance that comes from the surface of water at a place, towards an eye, and how much of what
/// is below it does not come through: what it mirrors of land and sky, and the sun's glitter.
struct WaterSurface {
  glm::vec3 radiance{0.0F};
  float reflectance = 0.0F;
};
WaterSurface water_surface(const glm::dvec3& at_m, const glm::dvec3& eye_m, const Waves& waves,
                           const Mirrored& mirrored, const SunOnWater& sun);

/// Radiance of a picture of the sky (Landscape::sky) in a unit direction, between its pixels.
glm::vec3 sky_radiance(const Image& sky, const glm::dvec3& direction);

}  // namespace wold::ground
