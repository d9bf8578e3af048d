#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace wold::work {

/// The files that a scene is read from: its own and those that it names.
std::vector<std::filesystem::path> input_files(const std::filesystem::path& file,
                                               const scene::Scene& scene);

/// Refuses to write `output` over one of the inputs, also under another name. `option` is the one
/// that names it. Throws InputError.
void require_no_input(const std::filesystem::path& output,
                      std::span<const std::filesystem::path> inputs,
                      std::string_view option = "--out");

/// Refuses an output folder in which an input has a place where a run of the scene writes; but
/// FOLDER/scene.toml as it was written may be rendered again. Throws InputError.
void require_inputs_kept(const std::filesystem::path& folder,
                         std::span<const std::filesystem::path> inputs, const scene::Scene& scene);

}  // namespace wold::work
