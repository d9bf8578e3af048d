#include "render/renderer_program.h"

#include <fmt/format.h>

#include "core/error.h"
#include "render/short_run.h"

namespace wold::render {
namespace {

RendererError unknown(const Renderer& kind, const FoundProgram& found, const Answer& answer) {
  return RendererError(fmt::format(
      "{}, which is not {}: asked for its --version, it ended with {}; name another by {} or "
      "{}{}",
      where_from(found), kind.expected_program, how_it_ended(answer), kind.program.option,
      kind.program.variable, last_lines(answer)));
}

}  // namespace

std::optional<std::string> version_after(std::string_view name, const Answer& answer) {
  for (const std::string& line : answer.lines) {
    if (!line.starts_with(name) || line.size() <= name.size() + 1 || line[name.size()] != ' ')
      continue;
    const std::string rest = line.substr(name.size() + 1);
    return rest.substr(0, rest.find(' '));
  }
  return std::nullopt;
}

std::string where_from(const FoundProgram& found) {
  if (found.chosen_by == "PATH")
    return fmt::format("{} is the first on the PATH", found.path.string());
  return fmt::format("{} names {}", found.chosen_by, found.path.string());
}

std::string described(const RendererProgram& program) {
  const std::string path = program.found.path.string();
  return fmt::format("{} {} ({})", display_name(*program.kind), program.version,
                     program.form == ProgramForm::python
                         ? fmt::format("package {} of {}", program.kind->python_package, path)
                         : path);
}

RendererProgram recognise(const Renderer& kind, const FoundProgram& found,
                          const Interrupted& interrupted) {
  const Answer answer = ask({found.path.string(), "--version"}, neutral_folder, interrupted);
  if (auto program = kind.recognise(found, answer, interrupted)) return std::move(*program);
  throw unknown(kind, found, answer);
}

}  // namespace wold::render
