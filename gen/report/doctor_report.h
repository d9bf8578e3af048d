#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/diagnosis.h"

namespace wold::report {

/// A renderer's build that is not used.
struct OtherBuild {
  const render::Renderer* kind = nullptr;
  render::OtherProgram program;
};

/// All that `wold doctor` has found.
struct DoctorFindings {
  std::vector<render::Diagnosis> renderers;
  std::vector<OtherBuild> other_builds;
  std::optional<render::OtherProgram> ffmpeg;
};

/// Whether any renderer shows all that a scene can have.
bool is_any_complete(const DoctorFindings& findings);

/// For people: what was found, what each line means and what to do.
std::string doctor_text(const DoctorFindings& findings);

/// The stable form, see docs/renderers.md.
std::string doctor_json(const DoctorFindings& findings);

}  // namespace wold::report
