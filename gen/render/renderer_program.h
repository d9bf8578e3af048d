#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "render/renderer.h"

namespace wold::render {

/// What kind of program a renderer is run by: itself, or a Python that has it as a package.
enum class ProgramForm { itself, python };

/// A renderer that has said what it is.
struct RendererProgram {
  const Renderer* kind = nullptr;
  ProgramForm form = ProgramForm::itself;
  FoundProgram found;
  std::string version;             ///< "3.4.1"; of a Python its package's
  std::string python;              ///< of a Python "3.11.2", else ""
  std::filesystem::path module;    ///< of a Python where its package is, else empty
  std::filesystem::path launcher;  ///< the script that it runs, such as Blender's; else empty
};

/// "Blender 3.4.1 (/usr/bin/blender)" or "Blender 5.2.2 (package bpy of /opt/v/bin/python)".
std::string described(const RendererProgram& program);

/// "3.4.1" of "Blender 3.4.1" and of "Blender 3.4.1 LTS"; nothing when no line begins with the
/// name.
std::optional<std::string> version_after(std::string_view name, const Answer& answer);

/// "--blender names /bin/true" or "/usr/bin/blender is the first on the PATH".
std::string where_from(const FoundProgram& found);

/// Asks a program what it is, by --version. In its place there may be a Python that has it as a
/// package, which is asked for without loading it. Throws RendererError that says what was found
/// and what to do when it is neither, and FileError when a shipped file is not installed.
RendererProgram recognise(const Renderer& kind, const FoundProgram& found,
                          const Interrupted& interrupted);

}  // namespace wold::render
