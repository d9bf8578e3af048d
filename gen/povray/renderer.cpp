#include "povray/renderer.h"

#include <fmt/format.h>

#include "core/files.h"
#include "povray/data_only.h"
#include "povray/probe.h"
#include "render/command.h"
#include "render/short_run.h"

namespace wold::povray {
namespace fs = std::filesystem;
namespace {

using render::RendererProgram;

std::optional<RendererProgram> recognise(const render::FoundProgram& found,
                                         const render::Answer& answer, const render::Interrupted&) {
  const auto version = version_after("POV-Ray", answer);
  if (!version) return std::nullopt;
  return RendererProgram{&renderer(), render::ProgramForm::itself, found, *version, {}, {}, {}};
}

/// POV-Ray splits its arguments at spaces even when the shell did not.
std::string quoted(const std::string& path) {
  const char quote = path.find('"') == std::string::npos ? '"' : '\'';
  return fmt::format("{}{}{}", quote, path, quote);
}

/// Starts POV-Ray with a stack that is deep enough (preload/deep_stack.cpp); nothing where that
/// library is not, or lies where the loader cannot find it. Stacks count whole against a limit of
/// memory, and POV-Ray hangs when it gets none: with a limit they stay as they are.
std::vector<std::string> with_deep_stack(const render::Job& job) {
  if (job.memory_bytes > 0.0) return {};
  const std::string library = shipped_library("deep_stack").string();
  if (library.empty() || library.find_first_of(" :") != std::string::npos) return {};
  return {"/usr/bin/env", "LD_PRELOAD=" + library};
}

/// Antialiasing stands in the folder's povray.ini, which POV-Ray reads where it is started. Names
/// are relative to there: above may be folders whose names no quoting saves.
render::Command command(const render::Job& job, const fs::path& output) {
  std::vector<std::string> arguments = with_deep_stack(job);
  arguments.insert(arguments.end(), {job.program.found.path.string(), "+Iscene.pov", "+L.",
                                     fmt::format("Declare=FRAME={}", job.frame),
                                     "+O" + quoted(fs::relative(output, job.scene_folder).string()),
                                     "+FN8", fmt::format("+W{}", job.size_px.x),
                                     fmt::format("+H{}", job.size_px.y), "-D", "-P", "+V"});
  if (job.threads > 0) arguments.push_back(fmt::format("+WT{}", job.threads));
  return {std::move(arguments), fs::absolute(job.scene_folder)};
}

/// "Rendered 1024 of 921600 pixels (0%)"; the pixels are finer than the percent
std::optional<double> fraction_done(std::string_view line) {
  constexpr std::string_view mark = "Rendered ";
  constexpr std::string_view middle = " of ";
  const std::size_t of = line.find(middle);
  if (!line.starts_with(mark) || of == std::string_view::npos) return std::nullopt;
  const auto done = render::leading_finite(line.substr(mark.size()));
  const auto total = render::leading_finite(line.substr(of + middle.size()));
  if (!done || !total || *total <= 0.0) return std::nullopt;
  return *done / *total;
}

std::string probe_content(const RendererProgram&) { return content_hash(probe_scene()); }

}  // namespace

const render::Renderer& renderer() {
  static const render::Renderer povray = {
      .program = {"POV-Ray", "povray", "WOLD_POVRAY", "--povray"},
      .option_doc = "POV-Ray",
      .expected_program = "POV-Ray",
      .state_extension = ".pov-state",
      .templates = "templates/povray",
      .recognise = recognise,
      .command = command,
      .fraction_done = fraction_done,
      .probe = probe,
      .probe_content = probe_content,
      .require_data_only = require_data_only};
  return povray;
}

}  // namespace wold::povray
