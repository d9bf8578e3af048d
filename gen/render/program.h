#pragma once

#include <filesystem>

namespace wold::render {

/// An external program: what people call it and where it is looked for.
struct ExternalProgram {
  const char* display_name;
  const char* name;      ///< on the PATH, and of its Debian package
  const char* variable;  ///< of the environment, names another program
};

/// Its absolute path: what the variable names when it is set, otherwise the first of its name on
/// the PATH. Throws RendererError that says what to install when there is none.
std::filesystem::path find_program(const ExternalProgram& program);

}  // namespace wold::render
