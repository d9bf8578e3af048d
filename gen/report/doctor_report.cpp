#include "report/doctor_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "render/capabilities_json.h"
#include "work/renderer_fault.h"

namespace wold::report {
namespace {

using Json = nlohmann::ordered_json;
using render::Capabilities;

std::string line(std::string_view name, std::string_view value, const std::string& meaning) {
  return fmt::format("  {:10}{:10}{}\n", name, value, meaning);
}

std::string volumes_line(const render::Diagnosis& diagnosis) {
  return diagnosis.can->volumes
             ? line("volumes", "yes", "it shows grass as texels, and clouds as volumes")
             : line("volumes", "no",
                    "it shows neither grass as texels nor clouds as volumes: take " +
                        work::other_build(*diagnosis.kind) + ", or --grass blades");
}

std::string fog_line(const render::Diagnosis& diagnosis) {
  return diagnosis.can->fog ? line("fog", "yes", "it shows snow that is far away")
                            : line("fog", "no",
                                   "it does not show snow that is far away: take " +
                                       work::other_build(*diagnosis.kind));
}

std::string nanovdb_meaning(const Capabilities& can) {
  if (!can.nanovdb) return "it does not say how it holds volumes";
  if (*can.nanovdb) return "volumes take memory only where something is";
  return can.volumes ? "volumes take memory also where nothing is: several times more"
                     : "it was built without it, and Blender shows no volumes without it since 5.0";
}

std::string nanovdb_line(const Capabilities& can) {
  const std::string_view value = !can.nanovdb ? "unknown" : *can.nanovdb ? "yes" : "no";
  return line("NanoVDB", value, nanovdb_meaning(can));
}

std::string devices_line(const Capabilities& can) {
  if (can.devices.empty())
    return line("devices", "cpu",
                "no graphics card that it can compute on: render.device = \"gpu\" is refused");
  std::string cards;
  for (const render::Device& device : can.devices)
    cards += fmt::format("{}{} ({})", cards.empty() ? "" : ", ", device.name, device.type);
  return line("devices", "cpu, gpu", "render.device = \"gpu\" or \"auto\" takes " + cards);
}

std::string capability_lines(const render::Diagnosis& diagnosis) {
  const Capabilities& can = *diagnosis.can;
  std::string text = volumes_line(diagnosis) + fog_line(diagnosis);
  if (diagnosis.kind->has_devices) text += nanovdb_line(can) + devices_line(can);
  return text +
         line("threads", std::to_string(can.threads), "of the processor; --threads takes fewer");
}

std::string chosen_text(const render::FoundProgram& found) {
  return found.chosen_by == "PATH" ? "the first on the PATH" : "named by " + found.chosen_by;
}

/// "Blender 3.4.1 (/usr/bin/blender), the first on the PATH: ..."
std::string heading(const render::Diagnosis& diagnosis) {
  const std::string name(render::display_name(*diagnosis.kind));
  if (!diagnosis.found) return name + ": missing\n";
  if (!diagnosis.program) return name + ": not found\n";
  const std::string text =
      fmt::format("{}, {}: ", described(*diagnosis.program), chosen_text(*diagnosis.found));
  if (!diagnosis.can) return text + "it fails\n";
  return text + (render::is_complete(diagnosis) ? "it makes every picture\n"
                                                : "it does not show everything\n");
}

std::string text_of(const render::Diagnosis& diagnosis) {
  if (diagnosis.can) return heading(diagnosis) + capability_lines(diagnosis);
  return heading(diagnosis) + "  " + diagnosis.problem + "\n";
}

std::string ffmpeg_text(const std::optional<render::OtherProgram>& ffmpeg) {
  if (!ffmpeg)
    return "FFmpeg: missing\n  `wold film` needs it; install it with `apt-get install ffmpeg` or "
           "set "
           "WOLD_FFMPEG\n";
  return fmt::format("FFmpeg {} ({}): `wold film` makes films\n", ffmpeg->version, ffmpeg->path);
}

/// Null where there is nothing to say.
Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json json_of(const render::OtherProgram& program) {
  return {{"program", program.path}, {"version", program.version}};
}

Json json_of(const render::Diagnosis& diagnosis) {
  Json json = {{"renderer", diagnosis.kind->program.name},
               {"state", render::state_of(diagnosis)},
               {"program", nullptr},
               {"chosen_by", nullptr},
               {"version", nullptr},
               {"module", nullptr},
               {"capabilities", nullptr},
               {"problem", text_or_null(diagnosis.problem)}};
  if (diagnosis.found) {
    json["program"] = diagnosis.found->path.string();
    json["chosen_by"] = diagnosis.found->chosen_by;
  }
  if (diagnosis.program) {
    json["version"] = diagnosis.program->version;
    json["module"] = diagnosis.program->form == render::ProgramForm::python;
  }
  if (diagnosis.can) json["capabilities"] = render::to_json(*diagnosis.can);
  return json;
}

}  // namespace

bool is_any_complete(const DoctorFindings& findings) {
  return std::ranges::any_of(findings.renderers, render::is_complete);
}

std::string doctor_text(const DoctorFindings& findings) {
  std::string text;
  for (const render::Diagnosis& diagnosis : findings.renderers) text += text_of(diagnosis);
  for (const OtherBuild& other : findings.other_builds)
    text += fmt::format("{0} {1} ({2}): not used; {3} {2} takes it\n", display_name(*other.kind),
                        other.program.version, other.program.path, other.kind->program.option);
  return text + ffmpeg_text(findings.ffmpeg);
}

std::string doctor_json(const DoctorFindings& findings) {
  Json renderers = Json::array();
  for (const render::Diagnosis& diagnosis : findings.renderers)
    renderers.push_back(json_of(diagnosis));
  Json others = Json::array();
  for (const OtherBuild& other : findings.other_builds) others.push_back(json_of(other.program));
  const Json json = {{"version", 1},
                     {"complete", is_any_complete(findings)},
                     {"renderers", std::move(renderers)},
                     {"other_blenders", std::move(others)},
                     {"ffmpeg", findings.ffmpeg ? json_of(*findings.ffmpeg) : Json()}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace wold::report
