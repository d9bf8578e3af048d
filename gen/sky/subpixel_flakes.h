#pragma once

#include <cstdint>
#include <vector>

#include "snow/flake_look.h"
#include "snow/snow_view.h"

namespace wold::sky {

/// The flakes, or where too many of them are behind each other, as a whirl's, fewer: of those
/// fainter than some opacity a fraction, all with that opacity, which dims as much on average.
/// Which ones is keyed by seed and place. Keeps their order. A ray passes at most `max_on_a_ray`
/// of them, on average over a small part of the picture (landscape::Needs).
std::vector<snow::SeenFlake> without_subpixel_flakes(std::vector<snow::SeenFlake> flakes,
                                                     const snow::Frustum& frustum,
                                                     std::uint64_t seed, double max_on_a_ray);

}  // namespace wold::sky
