#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/job.h"

namespace wold::render {

/// The arguments that make `program` render `job` to `output`, the program first. They are meant
/// to be run in the job's scene folder; `program` and `output` are absolute.
std::vector<std::string> command_line(const Job& job, const std::filesystem::path& program,
                                      const std::filesystem::path& output);

/// How far a line of the renderer's output says it is, in [0, 1]; nothing for any other line.
std::optional<double> progress_fraction(Renderer renderer, std::string_view line);

}  // namespace wold::render
