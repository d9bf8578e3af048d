#include "render/probe.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/error.h"
#include "core/file_list.h"
#include "core/files.h"
#include "render/capabilities_json.h"
#include "render/command.h"
#include "render/povray_probe.h"
#include "render/short_run.h"

namespace wold::render {
namespace {

constexpr std::string_view mark = "wold: probe ";

RendererError no_answer(const RendererProgram& program, const std::string& reason,
                        const Answer& answer) {
  return RendererError(fmt::format(
      "{} does not say what it can show: {}; expected a line \"{}{{...}}\"; see `wold "
      "doctor`, or name another build by {}{}",
      described(program), reason, mark, external_program(program.kind).option, last_lines(answer)));
}

Capabilities probe_blender(const RendererProgram& program,
                           const std::function<bool()>& interrupted) {
  const Command command = launch(program, {"--probe"});
  const Answer answer = ask(command.arguments, command.folder, interrupted);
  if (!has_succeeded(answer)) throw no_answer(program, how_it_ended(answer), answer);
  for (const std::string& line : answer.lines) {
    if (!line.starts_with(mark)) continue;
    try {
      return capabilities_of(nlohmann::json::parse(line.substr(mark.size())));
    } catch (const nlohmann::json::exception& error) {
      throw no_answer(program, error.what(), answer);
    }
  }
  throw no_answer(program, how_it_ended(answer), answer);
}

}  // namespace

Capabilities probe(const RendererProgram& program, const std::function<bool()>& interrupted) {
  return program.kind == Renderer::povray ? probe_povray(program, interrupted)
                                          : probe_blender(program, interrupted);
}

std::string probe_content(const RendererProgram& program) {
  if (program.kind == Renderer::povray) return content_hash(povray_probe_scene());
  return hash_of_programs_below(program.launcher.parent_path());
}

}  // namespace wold::render
