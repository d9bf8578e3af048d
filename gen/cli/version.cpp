#include "cli/commands.h"
#include "console/output.h"
#include "film/exporters.h"
#include "report/version_report.h"

namespace wold::cli {

ExitCode run_version(bool json) {
  std::vector<report::RendererHere> renderers;
  for (const exporter::Exporter* one : film::exporters())
    if (one->renderer)
      renderers.push_back({&*one->renderer, render::program_on_machine(*one->renderer)});
  const auto text = json ? report::version_json : report::version_text;
  console::print_data(text(renderers, render::diagnose_ffmpeg()));
  return ExitCode::done;
}

}  // namespace wold::cli
