#pragma once

#include <toml++/toml.h>

#include <filesystem>

namespace wold {

/// What a file of models/ has. Throws FileError, with the line where it is no TOML.
toml::table read_model_file(const std::filesystem::path& file);

}  // namespace wold
