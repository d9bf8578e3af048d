#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "render/process.h"

namespace wold::render {

/// Longest time in which a program has to say what it is or what it can do. Blender may need half
/// of it to start from a network's disk.
inline constexpr std::chrono::seconds longest_answer{60};

/// A folder from which no program imports or reads anything of its own accord.
inline constexpr const char* neutral_folder = "/";

/// What a program said, and how it ended.
struct Answer {
  std::vector<std::string> lines;  ///< of standard output and error; empty ones are left out
  std::optional<ProcessEnd> end;   ///< nothing: it was stopped after longest_answer
};

/// Whether the program ended by itself with exit code 0.
bool has_succeeded(const Answer& answer);

/// "exit code 1", "killed by ..." or "no answer after 60 s".
std::string how_it_ended(const Answer& answer);

/// The last lines, indented, each with a line break before it.
std::string last_lines(const Answer& answer);

/// Runs a program in `folder` to its end. `interrupted` is asked several times a second. Throws
/// RendererError when it cannot be started, and InterruptedError.
Answer ask(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
           const std::function<bool()>& interrupted);

}  // namespace wold::render
