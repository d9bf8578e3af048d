#pragma once

#include <string>

#include "scene/registry.h"
#include "scene/scene.h"

namespace wold::scene {

/// Every key of the scene with its value, "grass.blades = 400", one a line and nothing else: what
/// files that are made from a scene are told apart by. Words for people do not change it.
std::string settings_text(const Scene& scene);

/// The whole scene as TOML: every key with its value, its meaning and what it accepts. Parsing it
/// gives an equal scene, and writing that gives the same text.
std::string resolved_toml(const Scene& scene);

/// "blades = 400" with a line end; and with a comment before it, what the key means and accepts.
std::string assignment(const Key& key, const Scene& scene);
std::string explained_assignment(const Key& key, const Scene& scene);

/// Markdown tables of all keys: default, what is accepted, meaning.
std::string keys_markdown();

}  // namespace wold::scene
