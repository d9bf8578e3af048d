#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "landscape/landscape.h"
#include "landscape/raised_cast.h"
#include "passes/ground_cast.h"
#include "passes/seen_place.h"
#include "passes/standing_blades.h"
#include "passes/standing_grass.h"

namespace wold::passes {

/// What is seen along a ray.
struct Sight {
  GrassSight grass;  ///< before blades and ground
  BladeHit blade;    ///< before the ground
  double ground_m = std::numeric_limits<double>::infinity();

  bool meets_blade() const;
  /// Before any blade.
  bool meets_ground() const;
  /// What is seen first, or where volumes hide half of what is behind them.
  SeenPlace seen(const glm::dvec3& eye_m, const glm::dvec3& direction) const;
};

/// Looks along rays from a landscape's camera.
class Sights {
 public:
  /// `landscape` has to outlive it. Throws FileError when a volume cannot be read.
  explicit Sights(const landscape::Landscape& landscape);

  /// Along a unit direction. `sight` is made anew.
  void look(const glm::dvec3& direction, Sight& sight) const;

  /// Unit normal of the ground, or of what stands out of it, at a place in world space.
  glm::dvec3 ground_normal(const glm::dvec3& at_m) const;

 private:
  glm::dvec3 eye_m_;
  GroundCast ground_;
  landscape::RaisedCast raised_;
  StandingGrass grass_;
  StandingBlades blades_;
};

}  // namespace wold::passes
