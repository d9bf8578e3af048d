#include "blender/renderer.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "blender/blender_module.h"
#include "core/error.h"
#include "core/file_list.h"
#include "core/files.h"
#include "render/capabilities_json.h"
#include "render/short_run.h"

namespace wold::blender {
namespace fs = std::filesystem;
namespace {

using Arguments = std::vector<std::string>;
using render::RendererProgram;

constexpr std::string_view probe_mark = "wold: probe ";

fs::path launcher() { return shipped_file("templates/blender/wold_render.py"); }

RendererError no_module(const render::FoundProgram& found, const std::string& python) {
  return RendererError(fmt::format(
      "{0}, a Python {1} without the package bpy; install it by `{2} -m pip install bpy`, or name "
      "Blender itself",
      where_from(found), python, found.path.string()));
}

RendererProgram python_program(const render::FoundProgram& found, const std::string& python,
                               const render::Interrupted& interrupted) {
  const auto module = find_blender_module(found.path, interrupted);
  if (!module) throw no_module(found, python);
  return {&renderer(), render::ProgramForm::python, found, module->version, python, module->place,
          launcher()};
}

std::optional<RendererProgram> recognise(const render::FoundProgram& found,
                                         const render::Answer& answer,
                                         const render::Interrupted& interrupted) {
  if (const auto version = version_after("Blender", answer))
    return RendererProgram{&renderer(), render::ProgramForm::itself, found, *version, {}, {},
                           launcher()};
  if (const auto python = version_after("Python", answer))
    return python_program(found, *python, interrupted);
  return std::nullopt;
}

/// Blender takes relative names from $PWD, not from the folder it was started in.
render::Command command(const render::Job& job, const fs::path& output) {
  Arguments arguments = {fs::absolute(job.scene_folder).string(),
                         std::to_string(job.frame),
                         "--out",
                         output.string(),
                         "--size",
                         fmt::format("{}x{}", job.size_px.x, job.size_px.y),
                         "--samples",
                         std::to_string(job.samples),
                         "--device",
                         job.device};
  if (job.threads > 0)
    arguments.insert(arguments.end(), {"--threads", std::to_string(job.threads)});
  return launch(job.program, arguments);
}

/// "wold: progress 0.25"
std::optional<double> fraction_done(std::string_view line) {
  constexpr std::string_view mark = "wold: progress ";
  if (!line.starts_with(mark)) return std::nullopt;
  return render::leading_finite(line.substr(mark.size()));
}

RendererError no_answer(const RendererProgram& program, const std::string& reason,
                        const render::Answer& answer) {
  return RendererError(fmt::format(
      "{} does not say what it can show: {}; expected a line \"{}{{...}}\"; see `wold "
      "doctor`, or name another build by {}{}",
      described(program), reason, probe_mark, program.kind->program.option, last_lines(answer)));
}

render::Capabilities probe(const RendererProgram& program, const render::Interrupted& interrupted) {
  const render::Command command = launch(program, {"--probe"});
  const render::Answer answer = render::ask(command.arguments, command.folder, interrupted);
  if (!has_succeeded(answer)) throw no_answer(program, how_it_ended(answer), answer);
  for (const std::string& line : answer.lines) {
    if (!line.starts_with(probe_mark)) continue;
    try {
      return render::capabilities_of(nlohmann::json::parse(line.substr(probe_mark.size())));
    } catch (const nlohmann::json::exception& error) {
      throw no_answer(program, error.what(), answer);
    }
  }
  throw no_answer(program, how_it_ended(answer), answer);
}

std::string probe_content(const RendererProgram& program) {
  return hash_of_programs_below(program.launcher.parent_path());
}

std::string advice(std::string_view things) {
  if (things != "grass" && things != "clouds") return {};
  return fmt::format("; this Blender may not show volumes: `wold doctor` says whether it does{}",
                     things == "grass" ? ", `--grass blades` does without them" : "");
}

}  // namespace

const render::Renderer& renderer() {
  static const render::Renderer blender = {
      .program = {"Blender", "blender", "WOLD_BLENDER", "--blender"},
      .option_doc = "Blender, or a Python that has the package bpy",
      .expected_program = "Blender and no Python",
      .better_builds = ", an official Blender or a Python with the package bpy (pip install bpy),",
      .python_package = "bpy",
      .has_devices = true,
      .has_numbered_names = true,
      .templates = "templates/blender",
      .recognise = recognise,
      .command = command,
      .fraction_done = fraction_done,
      .probe = probe,
      .probe_content = probe_content,
      .advice = advice};
  return blender;
}

render::Command launch(const RendererProgram& program, const Arguments& arguments) {
  const std::string path = program.found.path.string();
  Arguments all = program.form == render::ProgramForm::python
                      ? python_command(path)
                      // without the exit code a Python error still ends with 0
                      : Arguments{path, "-b", "--factory-startup", "--python-exit-code", "1", "-P"};
  all.insert(all.end(), {program.launcher.string(), "--"});
  all.insert(all.end(), arguments.begin(), arguments.end());
  return {std::move(all), render::neutral_folder};
}

}  // namespace wold::blender
