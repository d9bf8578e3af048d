#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "scene/rule.h"
#include "scene/scene.h"

namespace wold::scene {

/// A scene and where its text or an override gives which keys.
struct LocatedScene {
  Scene scene;
  Places places;
  std::vector<Problem> warnings;  ///< keys that were given under an old name, with their places
};

/// The scene of a TOML text. Keys that it leaves out keep the defaults of Scene; an empty text is
/// a whole scene. `file_name` is for messages and for relative paths in the text, which start at
/// its folder; those of overrides start where the program runs. `overrides` are `key=value`,
/// applied after the text in their order; a value is TOML or a bare word. The result depends on
/// these alone: neither files that the scene names nor the machine are looked at.
///
/// Throws one InputError with every problem: syntax, unknown tables and keys, wrong types, values
/// out of range, keys that contradict each other. Each has its position and says what was found
/// and what is accepted.
Scene parse_scene(std::string_view text, const std::string& file_name,
                  std::span<const std::string> overrides = {});

/// parse_scene() with the places of its keys, for later checks that blame them.
LocatedScene parse_located_scene(std::string_view text, const std::string& file_name,
                                 std::span<const std::string> overrides = {});

/// parse_scene() of a file's text. A file that is missing, unreadable or no file is an InputError,
/// too.
Scene read_scene(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// read_scene() with the places of its keys, for later checks that blame them.
LocatedScene read_located_scene(const std::filesystem::path& path,
                                std::span<const std::string> overrides = {});

}  // namespace wold::scene
