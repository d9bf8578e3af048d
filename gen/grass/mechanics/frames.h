#pragma once

#include <glm/glm.hpp>

namespace wold::grass {

/// What a point of Algorithm 1 has of a frame, and where it is.
struct PointFrame {
  glm::vec3 position_m;
  glm::vec3 tangent;  ///< unit
  glm::vec3 normal;   ///< unit and across the tangent, or zero: vein tissue
};

/// The frame of a point that has moved to `position_m` ([TVT], section 2.3, figure 6a). The old
/// tangent, prolonged down to the ground, meets it at the blade's foot; the new tangent points from
/// that foot to the point's new place:
///   tx' = sx' - (sx - sz / tz tx),  ty' = sy' - (sy - sz / tz ty),  tz' = sz',  normalised.
/// The normal turns with it, by the least rotation that takes the old tangent to the new one.
///
/// A tangent that is level within 1 degree meets the ground nowhere near, and on the ground a point
/// is its own foot: there the frame stays as it was.
PointFrame moved_frame(const PointFrame& before, const glm::vec3& position_m);

}  // namespace wold::grass
