#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wold::blender {

/// Blender as a package of Python, `bpy`.
struct BlenderModule {
  std::string version;          ///< "4.5.3"; "unknown" when it was not installed by pip
  std::filesystem::path place;  ///< the file that `import bpy` loads
};

/// The beginning of every command line that runs a Python: neither the environment nor the current
/// folder add to what it imports, and it writes no byte code.
std::vector<std::string> python_command(const std::filesystem::path& python);

/// The package bpy of a Python, nothing when it has none. It is not loaded. Throws RendererError
/// when the Python does not answer, and InterruptedError.
std::optional<BlenderModule> find_blender_module(const std::filesystem::path& python,
                                                 const std::function<bool()>& interrupted);

}  // namespace wold::blender
