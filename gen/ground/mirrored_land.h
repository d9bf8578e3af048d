#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/ground_map.h"
#include "ground/land_view.h"
#include "terrain/surroundings.h"
#include "terrain/water.h"

namespace wold::ground {

/// The land that still water mirrors towards an eye: what a ray meets that goes on from a place of
/// the water in the vertical plane of the eye's line of sight. Heights along those lines are kept.
class MirroredLand {
 public:
  /// `ground`: of the scene's square; `water` stands on it, and is as high as it is between the
  /// ground's samples.
  MirroredLand(const terrain::Surroundings& land, const Heightfield& ground,
               const terrain::Water& water, const glm::dvec3& eye_m, const Panorama& panorama);

  /// Where rays from a place on the water, going on away from the eye, meet land: for each of
  /// `rises` over distance, which rise themselves; none for those that meet the sky.
  std::vector<std::optional<glm::dvec2>> met(const glm::dvec3& from_m,
                                             const std::vector<double>& rises) const;

 private:
  struct Height {
    float distance_m;  ///< from the eye
    float height_m;    ///< as it looks on a round earth
  };
  std::vector<Height> line(const terrain::Surroundings& land, const Heightfield& ground,
                           const terrain::Water& water, double azimuth_rad) const;

  glm::dvec3 eye_m_;
  Panorama panorama_;
  std::vector<std::vector<Height>> lines_;  ///< by azimuth, outwards
};

}  // namespace wold::ground
