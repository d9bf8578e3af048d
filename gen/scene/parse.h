#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "scene/scene.h"

namespace wold::scene {

/// The scene of a TOML text. Keys that it leaves out keep the defaults of Scene; an empty text is
/// a whole scene. `file_name` is for messages and for relative paths in the text, which start at
/// its folder; those of overrides start where the program runs. `overrides` are `key=value`,
/// applied after the text in their order; a value is TOML or a bare word.
///
/// Throws one InputError with every problem: syntax, unknown tables and keys, wrong types, values
/// out of range, keys that contradict each other. Each has its position and says what was found
/// and what is accepted.
Scene parse_scene(std::string_view text, const std::string& file_name,
                  std::span<const std::string> overrides = {});

/// The same for a file. A file that is missing, unreadable or no file is an InputError, too.
Scene read_scene(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// A scene that was read, and what its author should change although it could be read.
struct Parsed {
  Scene scene;
  std::vector<Problem> warnings;  ///< keys that were given under an old name, with their places
};

/// What parse_scene() reads, with its warnings.
Parsed parse_with_warnings(std::string_view text, const std::string& file_name,
                           std::span<const std::string> overrides = {});

/// What read_scene() reads, with its warnings.
Parsed read_with_warnings(const std::filesystem::path& path,
                          std::span<const std::string> overrides = {});

}  // namespace wold::scene
