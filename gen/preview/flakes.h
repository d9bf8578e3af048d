#pragma once

#include <vector>

#include "landscape/landscape.h"
#include "landscape/perspective.h"
#include "preview/canvas.h"

namespace wold::preview {

/// Puts the fog before what has been painted.
void paint_fog(const landscape::Fog& fog, const landscape::Perspective& perspective,
               Canvas& canvas);

/// Puts snow that blows over the ground before what has been painted: the last of a landscape's
/// volumes, which are hazes.
void paint_haze(const std::vector<landscape::CloudBox>& clouds,
                const landscape::Perspective& perspective, Canvas& canvas);

/// Paints falling flakes over it where nothing nearer is.
void paint_flakes(const landscape::Flakes& flakes, const landscape::Perspective& perspective,
                  Canvas& canvas);

}  // namespace wold::preview
