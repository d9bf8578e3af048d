#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/noise.h"
#include "scene/scene.h"
#include "terrain/broken_surface.h"

namespace wold::terrain {

/// The look of bare soil: soils of wide areas, moist hollows, pale litter, and near the eye what
/// these are made of: clods and crumbs, stones of the scene's rock, and dead blades that lie about.
/// Keyed, the same at any step.
class Soil {
 public:
  /// As a map with that step, > 0, shows it: what is finer shows its mean. Clods do so where they
  /// are finer than slope_step_m().
  Soil(const scene::Terrain& terrain, std::uint64_t seed, double step_m);

  /// Radiance over that of a smooth white surface which faces `up` and is lit by the sun and the
  /// sky: terrain.ground_albedo on the mean. World space; `up`, not below the horizon, and `to_sun`
  /// are unit vectors.
  glm::vec3 at(const glm::dvec2& at_m, const glm::dvec3& up, const glm::dvec3& to_sun) const;

  /// Linear red, green and blue.
  const glm::vec3& mean_albedo() const { return albedo_; }

 private:
  static constexpr double moisture_m = 3.5, litter_m = 0.35, blade_m = 0.05;

  double litter_at(const glm::dvec2& at_m) const;
  glm::vec3 earth_at(const glm::dvec2& at_m) const;
  glm::vec3 with_blades(const glm::vec3& earth, const glm::dvec2& at_m) const;
  glm::vec3 with_stones(glm::vec3 earth, const glm::dvec2& at_m, const glm::dvec3& up,
                        const glm::dvec3& to_sun) const;

  glm::vec3 albedo_, rock_albedo_;
  double step_m_;
  ScaleFreeNoise wide_;
  Fbm moisture_, litter_, stony_;
  double wet_shown_, litter_shown_, blades_shown_;
  BrokenSurface<2> clods_;
  std::uint64_t blades_key_, stones_key_;
};

}  // namespace wold::terrain
