#pragma once

#include <vector>

#include "scene/rule.h"
#include "scene/scene.h"

namespace wold::scene {

/// Adds a problem for all keys that contradict each other, at the first of them that was given.
/// Keys that failed by themselves are not judged again.
void report_contradictions(const Scene& scene, const Places& places,
                           std::vector<Problem>& problems);

}  // namespace wold::scene
