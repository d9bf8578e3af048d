#include "render/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/number_text.h"
#include "render/blender_module.h"
#include "render/short_run.h"

namespace wold::render {
namespace fs = std::filesystem;
namespace {

using Arguments = std::vector<std::string>;

/// Blender takes relative names from $PWD, not from the folder it was started in.
Arguments blender_arguments(const Job& job, const fs::path& output) {
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
  return arguments;
}

/// POV-Ray splits its arguments at spaces even when the shell did not.
std::string quoted(const std::string& path) {
  const char quote = path.find('"') == std::string::npos ? '"' : '\'';
  return fmt::format("{}{}{}", quote, path, quote);
}

/// Antialiasing stands in the folder's povray.ini, which POV-Ray reads where it is started. Names
/// are relative to there: above may be folders whose names no quoting saves.
Arguments povray_arguments(const Job& job, const fs::path& output) {
  Arguments arguments = {job.program.found.path.string(),
                         "+Iscene.pov",
                         "+L.",
                         fmt::format("Declare=FRAME={}", job.frame),
                         "+O" + quoted(fs::relative(output, job.scene_folder).string()),
                         "+FN8",
                         fmt::format("+W{}", job.size_px.x),
                         fmt::format("+H{}", job.size_px.y),
                         "-D",
                         "-P",
                         "+V"};
  if (job.threads > 0) arguments.push_back(fmt::format("+WT{}", job.threads));
  return arguments;
}

std::optional<double> leading_finite(std::string_view text) {
  const auto number = leading_number<double>(text);
  if (!number || !std::isfinite(number->value)) return std::nullopt;
  return number->value;
}

/// "wold: progress 0.25"
std::optional<double> blender_fraction(std::string_view line) {
  constexpr std::string_view mark = "wold: progress ";
  if (!line.starts_with(mark)) return std::nullopt;
  return leading_finite(line.substr(mark.size()));
}

/// "Rendered 1024 of 921600 pixels (0%)"; the pixels are finer than the percent
std::optional<double> povray_fraction(std::string_view line) {
  constexpr std::string_view mark = "Rendered ";
  constexpr std::string_view middle = " of ";
  const std::size_t of = line.find(middle);
  if (!line.starts_with(mark) || of == std::string_view::npos) return std::nullopt;
  const auto done = leading_finite(line.substr(mark.size()));
  const auto total = leading_finite(line.substr(of + middle.size()));
  if (!done || !total || *total <= 0.0) return std::nullopt;
  return *done / *total;
}

}  // namespace

Command launch(const RendererProgram& program, const std::vector<std::string>& arguments) {
  const std::string path = program.found.path.string();
  Arguments all = program.form == ProgramForm::python
                      ? python_command(path)
                      // without the exit code a Python error still ends with 0
                      : Arguments{path, "-b", "--factory-startup", "--python-exit-code", "1", "-P"};
  all.insert(all.end(), {program.launcher.string(), "--"});
  all.insert(all.end(), arguments.begin(), arguments.end());
  return {std::move(all), neutral_folder};
}

Command render_command(const Job& job, const fs::path& output) {
  if (job.program.form == ProgramForm::povray)
    return {povray_arguments(job, output), fs::absolute(job.scene_folder)};
  return launch(job.program, blender_arguments(job, output));
}

std::optional<double> progress_fraction(Renderer renderer, std::string_view line) {
  const auto fraction =
      renderer == Renderer::blender ? blender_fraction(line) : povray_fraction(line);
  if (!fraction) return std::nullopt;
  return std::clamp(*fraction, 0.0, 1.0);
}

}  // namespace wold::render
