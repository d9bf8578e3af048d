#pragma once

#include <vector>

#include "scene/scene.h"

namespace wold::scene {

/// What the numbers of terrain.cover stand for: the scene's [[cover_classes]], or, where it has
/// none, those of ESA WorldCover ([WorldCover]). Trees, shrubs and houses are not drawn: their
/// ground has their colour from above.
std::vector<CoverClass> cover_classes_of(const Scene& scene);

}  // namespace wold::scene
