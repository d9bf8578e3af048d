#include "render/renderer_program.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "core/error.h"
#include "core/files.h"
#include "render/blender_module.h"
#include "render/short_run.h"

namespace wold::render {
namespace {

/// "3.4.1" of "Blender 3.4.1" and of "Blender 3.4.1 LTS"; nothing when no line begins so.
std::optional<std::string> version_after(std::string_view name, const Answer& answer) {
  for (const std::string& line : answer.lines) {
    if (!line.starts_with(name) || line.size() <= name.size() + 1 || line[name.size()] != ' ')
      continue;
    const std::string rest = line.substr(name.size() + 1);
    return rest.substr(0, rest.find(' '));
  }
  return std::nullopt;
}

/// "--blender names /bin/true" or "/usr/bin/blender is the first on the PATH".
std::string where_from(const FoundProgram& found) {
  if (found.chosen_by == "PATH")
    return fmt::format("{} is the first on the PATH", found.path.string());
  return fmt::format("{} names {}", found.chosen_by, found.path.string());
}

RendererError unknown(Renderer kind, const FoundProgram& found, const Answer& answer) {
  const bool is_blender = kind == Renderer::blender;
  const ExternalProgram& known = external_program(kind);
  return RendererError(fmt::format(
      "{}, which is not {}: asked for its --version, it ended with {}; name another by {} or "
      "{}{}",
      where_from(found), is_blender ? "Blender and no Python" : "POV-Ray", how_it_ended(answer),
      known.option, known.variable, last_lines(answer)));
}

RendererError no_module(const FoundProgram& found, const std::string& python) {
  return RendererError(fmt::format(
      "{0}, a Python {1} without the package bpy; install it by `{2} -m pip install bpy`, or name "
      "Blender itself",
      where_from(found), python, found.path.string()));
}

std::filesystem::path launcher() { return shipped_file("templates/blender/wold_render.py"); }

RendererProgram python_program(const FoundProgram& found, const std::string& python,
                               const std::function<bool()>& interrupted) {
  const auto module = find_blender_module(found.path, interrupted);
  if (!module) throw no_module(found, python);
  return {Renderer::blender, ProgramForm::python, found, module->version, python,
          module->place,     launcher()};
}

}  // namespace

std::string described(const RendererProgram& program) {
  const std::string path = program.found.path.string();
  return fmt::format("{} {} ({})", display_name(program.kind), program.version,
                     program.form == ProgramForm::python ? "package bpy of " + path : path);
}

RendererProgram recognise(Renderer kind, const FoundProgram& found,
                          const std::function<bool()>& interrupted) {
  const Answer answer = ask({found.path.string(), "--version"}, neutral_folder, interrupted);
  const auto version = version_after(display_name(kind), answer);
  if (kind == Renderer::povray && version)
    return {kind, ProgramForm::povray, found, *version, {}, {}, {}};
  if (kind == Renderer::blender && version)
    return {kind, ProgramForm::blender, found, *version, {}, {}, launcher()};
  const auto python = version_after("Python", answer);
  if (kind == Renderer::blender && python) return python_program(found, *python, interrupted);
  throw unknown(kind, found, answer);
}

}  // namespace wold::render
