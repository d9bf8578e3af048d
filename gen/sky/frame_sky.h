#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "place/site.h"
#include "sky/cloudy_sky.h"

namespace wold::sky {

/// The sky of one frame: clear, or with the clouds of that moment.
class FrameSky {
 public:
  /// Frame from 1. `scene` and `site` have to outlive it.
  FrameSky(const scene::Scene& scene, const place::Site& site, int frame, const glm::dvec3& eye_m);

  /// The light on the ground that has `clear` under a clear sky. Clouds stand before the sun and
  /// change the sky's own light.
  ColourMap light(const terrain::GroundLight& clear) const;

  /// From 0, clouds are closed and the clear sky counts for nothing, to 1, it is seen between them.
  double openness() const;

  /// Sets the sky and its clouds as the landscape's camera sees them: a clear sky without, and
  /// with a backdrop only when asked to.
  void show(landscape::Landscape& landscape, bool with_backdrop) const;

  /// The sky as Landscape::Unlit has it, by the landscape's camera.
  Image unlit(const landscape::Camera& camera) const;

 private:
  FactorMap sunlit_fraction(const GroundGrid& grid) const;
  GroundGrid shadow_grid(const ColourMap& light) const;

  const scene::Scene& scene_;
  const place::Site& site_;
  int frame_;
  std::optional<cloud::CloudState> clouds_;
  CloudySky sheets_;  ///< all layers
};

}  // namespace wold::sky
