#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "landscape/landscape.h"
#include "passes/ground_cast.h"
#include "passes/standing_grass.h"

namespace wold::passes {

/// What is seen along a ray.
struct Sight {
  GrassSight grass;  ///< before the ground
  double ground_m = std::numeric_limits<double>::infinity();

  bool meets_ground() const;
  /// How far it is to the ground, or to where grass hides half of what is behind it; infinite where
  /// there is neither.
  double distance_m() const;
  bool shows_grass() const { return grass.half_m < ground_m; }
};

/// Looks along rays from a landscape's camera.
class Sights {
 public:
  /// `landscape` has to outlive it. Throws FileError when a volume cannot be read.
  explicit Sights(const landscape::Landscape& landscape);

  /// Along a unit direction. `sight` is made anew.
  void look(const glm::dvec3& direction, Sight& sight) const;

  const GroundCast& ground() const { return ground_; }

 private:
  glm::dvec3 eye_m_;
  GroundCast ground_;
  StandingGrass grass_;
};

}  // namespace wold::passes
