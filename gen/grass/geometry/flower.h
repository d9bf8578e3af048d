#pragma once

#include <vector>

#include "grass/geometry/blade.h"
#include "scene/scene.h"

namespace wold::grass {

/// Makes blades (scatter_blades()) the stalks of flowers. After each stalk come the petals on its
/// tip and, where the flower has one, its disc; petals are as wide as they get where they end, and
/// their points meet at the tip.
///
/// Several stalks grow from one root stock. They are straight and of this year. Keyed by
/// `scattering`, by which the blades were scattered.
std::vector<Blade> with_flowers(std::vector<Blade> stalks, const scene::Flower& flower,
                                const Scattering& scattering);

}  // namespace wold::grass
