#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/job.h"

namespace wold::render {

/// A program and the folder it is started in.
struct Command {
  std::vector<std::string> arguments;  ///< the program first
  std::filesystem::path folder;
};

/// What makes the program render `job` to `output`, an absolute path.
Command render_command(const Job& job, const std::filesystem::path& output);

/// How far a line of the renderer's output says it is, in [0, 1]; nothing for any other line.
std::optional<double> progress_fraction(const Renderer& renderer, std::string_view line);

/// The number that a text begins with; nothing where it begins with none, or with one that is not
/// finite.
std::optional<double> leading_finite(std::string_view text);

}  // namespace wold::render
