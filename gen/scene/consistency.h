#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "scene/scene.h"

namespace wold::scene {

/// Where the user gave which keys, and which of these were wrong by themselves.
struct Places {
  std::map<std::string, SourcePosition> given;
  std::set<std::string> failed;
};

/// Adds a problem for all keys that contradict each other, at the first of them that was given.
/// Keys that failed by themselves are not judged again.
void report_contradictions(const Scene& scene, const Places& places,
                           std::vector<Problem>& problems);

}  // namespace wold::scene
