#pragma once

#include <vector>

#include "scene/rule.h"
#include "scene/scene.h"

namespace wold::scene {

/// What the keys of each species of the meadow owe each other and the patch. They are named as the
/// user gave them: in [grass], [ageing] and [fur], or in [[species]].
std::vector<Rule> species_rules(const Scene& scene);

}  // namespace wold::scene
