#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/ground_map.h"
#include "core/noise.h"
#include "ground/haze.h"
#include "ground/land_appearance.h"
#include "ground/land_view.h"
#include "landscape/landscape.h"
#include "light/daylight.h"
#include "terrain/lighting.h"
#include "terrain/surroundings.h"

namespace wold::ground {

/// The frame's light on ground that has some light under a clear sky.
using Illuminate = std::function<ColourMap(const terrain::GroundLight& clear)>;

/// The land around the scene's square in one frame: what it makes of the light on it, in the haze.
class LandAround {
 public:
  /// `land`, `day` and `haze` have to outlive it.
  LandAround(const terrain::Surroundings& land, const light::Daylight& day, const Haze& haze,
             LandAppearance appearance, const Illuminate& illuminate, std::uint64_t seed);

  /// Radiance that an eye sees of a place, of which a pixel covers `step_m`.
  glm::vec3 radiance(const glm::dvec2& at_m, double step_m) const;
  /// The same without the haze before it.
  glm::vec3 near_radiance(const glm::dvec2& at_m, double step_m) const;
  /// In a direction below the level one in which no land is seen: farther out there is only haze.
  glm::vec3 beyond(const glm::dvec3& direction) const { return day_.haze_radiance(direction, 1.0); }

 private:
  /// The light that clouds and snowfall leave, over that under a clear sky.
  struct Left {
    ColourMap of_sun, of_sky;
  };
  static Left left_of_light(const Square& square, const Illuminate& illuminate);
  const Left& left_at(const glm::dvec2& at_m) const;

  double sun_seen(const glm::dvec3& at_m) const;
  glm::vec3 irradiance(const glm::dvec3& at_m, const glm::dvec3& up) const;

  const terrain::Surroundings& land_;
  const light::Daylight& day_;
  const Haze& haze_;
  LandAppearance appearance_;
  std::vector<Left> left_;  ///< on squares about the scene's, from the smallest
  ScaleFreeNoise variation_;
  float wider_spread_;  ///< of places here, over that of places in the square
};

/// Radiance that an eye sees of a place on the land around, of which a pixel covers `step_m`.
using LandRadiance = std::function<glm::vec3(const glm::dvec2& at_m, double step_m)>;

/// Paints it over the sky of a backdrop, as the camera sees it: `land`, and what is `around` beyond
/// it.
void paint_land_around(const LandRadiance& land, const LandAround& around, const LandView& view,
                       const glm::dvec3& eye_m, landscape::Backdrop& backdrop);

}  // namespace wold::ground
