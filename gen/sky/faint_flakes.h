#pragma once

#include <cstdint>
#include <vector>

#include "snow/flake_look.h"
#include "snow/snow_view.h"

namespace wold::sky {

/// No ray of the picture passes more flakes than this on average over a small part of it. POV-Ray
/// ends abruptly when a ray has passed some 240 surfaces and still sees more than 1/255 of what is
/// behind.
inline constexpr double most_flakes_on_a_ray = 110.0;

/// The flakes, or where too many of them are behind each other, as a whirl's, fewer: of those
/// fainter than some opacity a share, all with that opacity, which dims as much on average. Which
/// ones is keyed by seed and place. Keeps their order.
std::vector<snow::SeenFlake> without_faint_flakes(std::vector<snow::SeenFlake> flakes,
                                                  const snow::Frustum& frustum, std::uint64_t seed);

}  // namespace wold::sky
