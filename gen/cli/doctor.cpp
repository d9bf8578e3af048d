#include "cli/commands.h"
#include "console/output.h"
#include "film/exporters.h"
#include "report/doctor_report.h"

namespace wold::cli {

ExitCode run_doctor(const DoctorOptions& options) {
  report::DoctorFindings findings;
  for (const exporter::Exporter* one : film::exporters()) {
    if (!one->renderer) continue;
    const auto chosen = options.programs.find(one->name);
    const render::Diagnosis& diagnosis = findings.renderers.emplace_back(
        render::diagnose(*one->renderer, chosen == options.programs.end() ? "" : chosen->second));
    for (const render::OtherProgram& other : render::other_builds(diagnosis))
      findings.other_builds.push_back({one->renderer, other});
  }
  findings.ffmpeg = render::diagnose_ffmpeg();
  console::print_data(options.json ? report::doctor_json(findings) : report::doctor_text(findings));
  return is_any_complete(findings) ? ExitCode::done : ExitCode::renderer;
}

}  // namespace wold::cli
