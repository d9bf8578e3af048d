#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ground/land_variety.h"

namespace wold::ground {

/// What land looks like at one place.
struct LandSample {
  glm::dvec3 up;  ///< upward unit normal
  double height_m;
  glm::vec3 radiance;  ///< over the irradiance there
};

/// What land looks like by how it lies, as places of the scene's own ground look: by slope, by
/// height and by aspect, in which meadows, rock and snow differ.
class LandAppearance {
 public:
  /// Places along a side of the square, of which land around has its look.
  static constexpr int places = 64;

  /// At least one sample.
  explicit LandAppearance(std::span<const LandSample> samples);

  /// Radiance over irradiance of land with this normal at a height: the mean of what lies alike.
  glm::vec3 at(const glm::dvec3& up, double height_m) const;

  /// How places differ from that mean, over it.
  const LandVariety& variety() const { return variety_; }

 private:
  static constexpr int slopes = 13, heights = 13, aspects = 8;

  glm::vec3 regression(std::span<const LandSample> samples, int slope, int height,
                       int aspect) const;

  double lowest_m_, highest_m_;
  std::vector<glm::vec3> table_;  ///< aspects first, then heights
  LandVariety variety_{{}};
};

}  // namespace wold::ground
