#pragma once

#include <vector>

#include "scene/starter_kinds.h"

namespace wold::scene {

// What grows in starter scenes beside the scene's grass, of which each of these is a change.
// `share` is relative to that of the grass itself, 1.

/// Low bushes, most of whose leaves stay green, amid the grass, as on hills that are grazed:
/// without anything as large the eye does not see how far away a slope is.
Species bushes(const Scene& scene);

/// Thin, yellowish grass in wide patches, as on poor ground.
Species pale_grass(const Scene& scene);

/// Tall, dark grass in small patches where it is moist.
Species lush_grass(const Scene& scene);

/// Yellow flowers amid the grass: two to a patch, one where much else stands.
Species hawkbits(const Scene& scene);

/// Gives a starter these plants in its grass, with their keys. Patches are of as many kinds as
/// there are ways in which plants stand together, so there are fewer variants of each.
void let_grow(Starter& starter, std::vector<Species> plants);

}  // namespace wold::scene
