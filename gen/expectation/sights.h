#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "expectation/bare_view.h"
#include "expectation/cloud_view.h"
#include "landscape/aggregate_appearance.h"
#include "landscape/landscape.h"

namespace wold::expectation {

/// A line of sight, and what it meets from the farthest to the nearest.
struct Sight {
  glm::dvec3 direction{0.0};  ///< unit vector
  bool meets_ground = false;
  Hit bare;  ///< the ground, or what is behind everything
  std::optional<landscape::AggregateAppearance> grass;  ///< of volumes, lit
  std::optional<landscape::AggregateAppearance> blades;
  SeenBox clouds;
};

/// How well the look of grass is known.
struct GrassKnowledge {
  std::size_t patches = 0;    ///< on so many patches of the ground stands what is seen
  double own_fraction = 1.0;  ///< of passages, those for which a volume of the same patch speaks
};

/// Fills in the volumes that sights go through on their way down to the ground. Throws FileError
/// when a volume cannot be read.
GrassKnowledge look_at_grass(const landscape::Landscape& landscape, std::vector<Sight>& sights);

/// Fills in the blades that sights go through on their way down to the ground.
void look_at_blades(const landscape::Landscape& landscape, std::vector<Sight>& sights);

}  // namespace wold::expectation
