#pragma once

#include "film/assemble.h"
#include "passes/ground_facts.h"

namespace wold::film {

/// What the passes of a frame are told beside its landscape. Everything has to outlive it; `frame`
/// is assemble_frame()'s of the same scene, site and grass.
passes::GroundFacts ground_facts(const scene::Scene& scene, const place::Site& site,
                                 const meadow::FrameGrass& now, const AssembledFrame& frame,
                                 const PatchLookup& lookup);

}  // namespace wold::film
