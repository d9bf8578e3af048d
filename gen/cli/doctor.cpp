#include "cli/commands.h"
#include "cli/doctor_report.h"
#include "cli/output.h"

namespace wold::cli {

ExitCode run_doctor(const DoctorOptions& options) {
  DoctorFindings findings;
  findings.renderers = {diagnose(render::Renderer::blender, options.blender),
                        diagnose(render::Renderer::povray, options.povray)};
  findings.other_blenders = other_blenders(findings.renderers.front());
  findings.ffmpeg = diagnose_ffmpeg();
  print_data(options.json ? doctor_json(findings) : doctor_text(findings));
  return is_any_complete(findings) ? ExitCode::done : ExitCode::renderer;
}

}  // namespace wold::cli
