#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wold::render {

/// An external program: what people call it and where it is looked for.
struct ExternalProgram {
  const char* display_name;
  const char* name;      ///< on the PATH, and of its Debian package
  const char* variable;  ///< of the environment, names another program
  const char* option;    ///< of the command line, stronger than the variable; "" when there is none
};

/// A program on this machine.
struct FoundProgram {
  std::filesystem::path
      path;               ///< absolute; links are not followed, since they say whose Python it is
  std::string chosen_by;  ///< "--blender", "WOLD_BLENDER" or "PATH"
};

/// Looks for a program: `chosen`, which the option named, is stronger than the variable, and that
/// is stronger than the first program of its name on the PATH. What the option or the variable name
/// is a path when there is a slash in it, else a name on the PATH. Throws RendererError that says
/// what to install or to correct when there is no such program.
FoundProgram find_program(const ExternalProgram& program, const std::string& chosen = {});

/// Every program in the folders of the PATH whose name begins with `prefix`, in their order.
std::vector<std::filesystem::path> programs_on_path(std::string_view prefix);

}  // namespace wold::render
