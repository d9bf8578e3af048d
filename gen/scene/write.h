#pragma once

#include <string>

#include "scene/scene.h"

namespace wold::scene {

/// The whole scene as TOML: every key with its value, its meaning and what it accepts. Parsing it
/// gives an equal scene, and writing that gives the same text.
std::string resolved_toml(const Scene& scene);

/// A short commented scene with the keys one changes first. Throws InputError when `name` does
/// not serve as a scene's name.
std::string starter_scene(const std::string& name);

/// Markdown tables of all keys: default, what is accepted, meaning.
std::string keys_markdown();

}  // namespace wold::scene
