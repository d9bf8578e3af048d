#include "cli/commands.h"
#include "console/output.h"
#include "report/doctor_report.h"

namespace wold::cli {

ExitCode run_doctor(const DoctorOptions& options) {
  report::DoctorFindings findings;
  findings.renderers = {render::diagnose(render::Renderer::blender, options.blender),
                        render::diagnose(render::Renderer::povray, options.povray)};
  findings.other_blenders = render::other_blenders(findings.renderers.front());
  findings.ffmpeg = render::diagnose_ffmpeg();
  console::print_data(options.json ? report::doctor_json(findings) : report::doctor_text(findings));
  return is_any_complete(findings) ? ExitCode::done : ExitCode::renderer;
}

}  // namespace wold::cli
