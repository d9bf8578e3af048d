#include "passes/sights.h"

#include <algorithm>
#include <cmath>

namespace wold::passes {

bool Sight::meets_ground() const { return std::isfinite(ground_m); }

double Sight::distance_m() const { return std::min(grass.half_m, ground_m); }

Sights::Sights(const landscape::Landscape& landscape)
    : eye_m_(landscape.camera.eye_m), ground_(landscape.terrain), grass_(landscape) {}

void Sights::look(const glm::dvec3& direction, Sight& sight) const {
  sight.ground_m = ground_.distance_m(eye_m_, direction);
  grass_.look(eye_m_, direction, sight.ground_m, sight.grass);
}

}  // namespace wold::passes
