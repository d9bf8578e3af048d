#pragma once

#include <span>

#include "core/layered_image.h"
#include "landscape/landscape.h"
#include "passes/ground_facts.h"
#include "passes/pass.h"

namespace wold::passes {

/// The passes of a landscape's picture, pixel by pixel: PassFacts says what each has. Fractions of
/// pixels are means over 4 x 4 rays, all else is of the ray through the pixel's middle. Clouds,
/// flakes and fog are left out: they have no surface. The same bytes with any number of threads.
/// Throws FileError when a volume cannot be read.
LayeredImage paint(const landscape::Landscape& landscape, const GroundFacts& facts,
                   std::span<const Pass> passes);

}  // namespace wold::passes
