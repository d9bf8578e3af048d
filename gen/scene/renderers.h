#pragma once

#include <string>
#include <vector>

#include "scene/registry.h"

/// The words of render.renderer: exporters by name, one of them, several, or "both".
namespace wold::scene {

/// What the key accepts alone: each exporter's name, then "both".
std::vector<std::string> renderer_words();

/// The names that a value of the key stands for, in the order of renderer_words(), each once;
/// "both" is Blender and POV-Ray.
std::vector<std::string> renderers_of(const Value& value);

/// The shortest value that stands for these names: a word where there is one, else a list.
Value renderers_value(const std::vector<std::string>& names);

/// The names for people: "both", "povray", or several with commas between them.
std::string renderers_text(const std::vector<std::string>& names);

}  // namespace wold::scene
