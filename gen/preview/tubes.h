#pragma once

#include <functional>

#include "core/tubes.h"
#include "landscape/perspective.h"
#include "preview/canvas.h"

namespace wold::preview {

/// A factor on what glows at a place in world space.
using LightAt = std::function<glm::vec3(const glm::dvec3& at_m)>;

/// Paints tubes where nothing nearer is; of many rings some are left out. `light` is asked at each
/// tube's root.
void paint_tubes(const Tubes& tubes, const glm::dmat4& world_from_cell, const LightAt& light,
                 const landscape::Perspective& perspective, Canvas& canvas);

}  // namespace wold::preview
