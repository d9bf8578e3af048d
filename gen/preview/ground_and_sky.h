#pragma once

#include "landscape/landscape.h"
#include "landscape/perspective.h"
#include "preview/canvas.h"

namespace wold::preview {

/// Paints the terrain, found by marching along a ray through each pixel's middle, and the sky
/// behind it, both as the landscape's pictures have them.
void paint_ground_and_sky(const landscape::Landscape& landscape,
                          const landscape::Perspective& perspective, Canvas& canvas);

}  // namespace wold::preview
