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

/// What runs wold_render.py in Blender or Python with these arguments. It is started in a folder
/// from which nothing is imported: never in that of the data.
Command launch(const RendererProgram& program, const std::vector<std::string>& arguments);

/// What makes the program render `job` to `output`, an absolute path.
Command render_command(const Job& job, const std::filesystem::path& output);

/// How far a line of the renderer's output says it is, in [0, 1]; nothing for any other line.
std::optional<double> progress_fraction(Renderer renderer, std::string_view line);

}  // namespace wold::render
