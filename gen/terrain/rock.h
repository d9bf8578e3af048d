#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/noise.h"
#include "terrain/broken_surface.h"

namespace wold::terrain {

/// The look of bare rock: beds that dip a little and differ in colour, thick ones made of thinner
/// ones, broken by joints into blocks, these into smaller ones and so on (cellular noise, Worley
/// 1996), from buttresses of 300 m to chips of 3 cm. Each block has a face of its own that turns
/// to or away from the light, and dark joints about it. Keyed, in space, so that steep faces show
/// blocks and not their plan drawn out.
class Rock {
 public:
  /// As a map with that step, > 0, shows it: what is finer than slope_step_m() is evened out.
  /// `albedo` is linear red, green and blue in [0, 1].
  Rock(const glm::vec3& albedo, std::uint64_t seed, double step_m);

  /// Radiance over that of a smooth white surface which faces `up` and is lit by the sun and the
  /// sky: the albedo on the mean, 2.69 times that at most. World space; `up`, not below the
  /// horizon, and `to_sun` are unit vectors.
  glm::vec3 at(const glm::dvec3& place_m, const glm::dvec3& up, const glm::dvec3& to_sun) const;

  /// The same of its debris: stones of 1.2 m down to 3 cm, mixed from all of its beds, each of its
  /// own shade, with dark gaps between them.
  glm::vec3 debris_at(const glm::dvec3& place_m, const glm::dvec3& up,
                      const glm::dvec3& to_sun) const;

  /// The same of a boulder: worn faces with few cracks, and lichens, paler than the rock, on a
  /// quarter of them. `up` is the boulder's.
  glm::vec3 boulder_at(const glm::dvec3& place_m, const glm::dvec3& up,
                       const glm::dvec3& to_sun) const;

  /// Share of the rock at a place on which snow can lie, in [0, 1]: its ledges, where faces are
  /// less steep than `steepest_deg`, give or take two degrees. Faces turn about a third as far as
  /// light shows them, and hard beds stand steeper than soft ones: both are choices.
  double ledges(const glm::dvec3& place_m, const glm::dvec3& up, double steepest_deg) const;

 private:
  glm::dvec3 bedded(const glm::dvec3& place_m) const;
  double bed_at(const glm::dvec3& bedded_m, double step_m) const;
  glm::vec3 stain_at(const glm::dvec3& place_m, double step_m) const;

  glm::vec3 albedo_;
  std::uint64_t key_;
  double step_m_;
  ScaleFreeNoise bend_, beds_;
  Fbm stain_;
  glm::dmat3 to_beds_;
  Fbm lichens_;
  BrokenSurface<3> blocks_, stones_, boulders_;
};

/// How much steeper ground is than where rock begins to show, degrees: that is terrain.rock_slope,
/// and less where the ground stands out (`exposure`: Surface::exposure()).
double beyond_rock_deg(double slope_deg, double exposure, double rock_slope_deg);

}  // namespace wold::terrain
