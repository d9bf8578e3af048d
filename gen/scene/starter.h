#pragma once

#include <string>
#include <vector>

namespace wold::scene {

/// What starter scenes there are: "hillside" first, "mountain", "clouds", "snow", "season".
const std::vector<std::string>& starter_kinds();

/// A short commented scene with the keys one changes first. Throws InputError when `name` does
/// not serve as a scene's name or `kind` is none of starter_kinds().
std::string starter_scene(const std::string& name, const std::string& kind);

}  // namespace wold::scene
