#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "render/renderer.h"

namespace wold::render {

/// What kind of program a renderer is run by.
enum class ProgramForm { blender, python, povray };

/// A renderer that has said what it is.
struct RendererProgram {
  Renderer kind = Renderer::blender;
  ProgramForm form = ProgramForm::blender;
  FoundProgram found;
  std::string version;             ///< "3.4.1"; of a Python its bpy's
  std::string python;              ///< of a Python "3.11.2", else ""
  std::filesystem::path module;    ///< of a Python where its bpy is, else empty
  std::filesystem::path launcher;  ///< the script that Blender or Python runs; of POV-Ray empty
};

/// "Blender 3.4.1 (/usr/bin/blender)" or "Blender 5.2.2 (package bpy of /opt/v/bin/python)".
std::string described(const RendererProgram& program);

/// Asks a program what it is, by --version. In Blender's place it may be a Python that has the
/// package bpy, which is asked for without loading it. `interrupted` is asked several times a
/// second. Throws RendererError that says what was found and what to do when it is neither, and
/// FileError when the launcher is not installed.
RendererProgram recognise(Renderer kind, const FoundProgram& found,
                          const std::function<bool()>& interrupted);

}  // namespace wold::render
