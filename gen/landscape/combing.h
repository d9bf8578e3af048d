#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "core/noise.h"
#include "scene/scene.h"

namespace wold::landscape {

/// How the wind has combed the meadow: blades lean with it, more in some strips than in others,
/// like waves that stand. The field is smooth, so that neighbouring patches lean nearly alike.
class Combing {
 public:
  explicit Combing(const scene::Scene& scene);

  /// Metres to the east and north by which the grass at a place leans over per metre of height.
  glm::dvec2 lean(const glm::dvec2& at_m) const;

 private:
  scene::Wind wind_;
  Fbm waves_;
  Fbm turns_;
};

}  // namespace wold::landscape
