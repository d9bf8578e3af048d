#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "ground/mirrored_land.h"
#include "ground/snowy_ground.h"
#include "ground/water_look.h"
#include "place/site.h"
#include "place/view.h"
#include "snow/weather.h"

namespace wold::ground {

/// Radiance of the sky, with its clouds, in a unit direction.
using SkyRadiance = std::function<glm::vec3(const glm::dvec3& direction)>;

/// Radiance of land as water mirrors it, without haze, on three maps: the scene's square, the land
/// next to it, and all land around.
struct SeenLand {
  ColourMap on_square, around, far_around;

  glm::vec3 at(const glm::dvec2& at_m) const;
};

/// What lakes reflect in one frame.
struct OverLakes {
  MirroredLand where;
  SeenLand land;
  SkyRadiance sky;
  ColourMap sunlight;  ///< irradiance of a plane that faces the sun
  glm::dvec3 eye_m;
};

/// The surface of a scene's lakes in one frame, from its eye. Ice is no water.
class LakeSurface {
 public:
  /// Site and ground have to outlive it; the site has water. `time_s`: since the first frame.
  LakeSurface(const place::Site& site, const SnowyGround& ground, double time_s, std::uint64_t seed,
              OverLakes over);

  /// Share of a piece of ground `step_m` wide about a place that is open water, in [0, 1].
  double open_water(const glm::dvec2& at_m, double step_m) const;

  /// What the surface sends to the eye from a place on the water, of waves that steps show.
  WaterSurface at(const glm::dvec2& at_m, double step_m) const;

  /// Adds the surface, where it is seen, to a map of what comes out of the water; `light`: the
  /// irradiance on level ground.
  void add_to(ColourMap& radiance, const ColourMap& light, const place::View& view) const;

 private:
  Waves waves(double step_m) const;
  WaterSurface surface(const glm::dvec2& at_m, const Waves& waves) const;

  const place::Site& site_;
  const SnowyGround& ground_;
  snow::WeatherMoment wind_;
  double time_s_;
  std::uint64_t seed_;
  OverLakes over_;
};

}  // namespace wold::ground
