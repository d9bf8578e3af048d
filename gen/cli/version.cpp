#include "cli/commands.h"
#include "console/output.h"
#include "film/exporters.h"
#include "report/version_report.h"

namespace wold::cli {

ExitCode run_version() {
  std::vector<report::RendererHere> renderers;
  for (const exporter::Exporter* one : film::exporters())
    if (one->renderer)
      renderers.push_back({&*one->renderer, render::program_on_machine(*one->renderer)});
  console::print_data(report::version_text(renderers, render::diagnose_ffmpeg()));
  return ExitCode::done;
}

}  // namespace wold::cli
