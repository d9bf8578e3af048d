#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace wold::work {

/// Everything a scene says that can change a file, by key as in messages: "grass.blades",
/// "clouds[1].kind". Values are TOML; of files they are the hashes of what is in them.
using SceneFacts = std::map<std::string, std::string>;

/// The facts of a scene: all its keys but its name and those that only say who works, on what,
/// with how many threads and for how long. Throws FileError when a file it names cannot be read.
SceneFacts facts_of(const scene::Scene& scene);

/// Equal for equal facts.
std::string hash_of(const SceneFacts& facts);

/// The keys that differ, in their order.
std::vector<std::string> changed_keys(const SceneFacts& now, const SceneFacts& then);

}  // namespace wold::work
