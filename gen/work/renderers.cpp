#include "work/renderers.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "core/error.h"
#include "core/interrupt.h"
#include "render/probe_cache.h"
#include "work/renderer_fault.h"

namespace wold::work {
namespace {

/// Whether anything depends on what the renderer can do.
bool has_to_be_probed(const scene::Scene& scene, const render::Renderer& renderer) {
  const SceneNeeds needs = needs_of(scene);
  return needs_volumes(needs) || needs.fog ||
         (renderer.has_devices && scene.render.device != scene::Device::cpu);
}

/// What a program can do. One that once could not do enough may have got a driver or a library
/// since then, and is asked again.
render::Capabilities capabilities(const render::RendererProgram& program,
                                  const scene::Scene& scene) {
  const render::ProbeAnswer answer = render::probe_once(program, interrupted);
  if (answer.is_new || fault_of(program, answer.capabilities, scene).empty())
    return answer.capabilities;
  return render::probe_anew(program, interrupted);
}

void say_what_it_computes_on(const render::RendererProgram& program,
                             const render::Capabilities& can, const scene::Scene& scene,
                             Progress& progress) {
  if (!program.kind->has_devices || scene.render.device != scene::Device::automatic) return;
  if (can.devices.empty())
    progress.say(
        fmt::format("render.device = \"auto\": {} found no graphics card and takes the processor",
                    display_name(*program.kind)));
}

/// As the job's option names it; nothing when it names none.
std::string chosen_program(const Job& job, const exporter::Exporter& exporter) {
  const auto chosen = job.programs.find(exporter.name);
  return chosen == job.programs.end() ? "" : chosen->second;
}

}  // namespace

void Renderers::check(const render::RendererProgram& program) const {
  if (!has_to_be_probed(job_.scene, *program.kind)) return;
  const render::Capabilities can = capabilities(program, job_.scene);
  if (const std::string fault = fault_of(program, can, job_.scene); !fault.empty())
    throw RendererError(fault);
  say_what_it_computes_on(program, can, job_.scene, progress_);
}

void Renderers::require(const exporter::Exporters& wanted) {
  const std::lock_guard lock(mutex_);
  std::vector<std::pair<const exporter::Exporter*, render::FoundProgram>> found;
  for (const exporter::Exporter* one : wanted)
    if (!ready_.contains(one))
      found.emplace_back(one, render::find_renderer(*one->renderer, chosen_program(job_, *one)));
  std::vector<std::pair<const exporter::Exporter*, render::RendererProgram>> programs;
  for (const auto& [one, program] : found)
    programs.emplace_back(one, render::recognise(*one->renderer, program, interrupted));
  for (const auto& [one, program] : programs) check(program);
  ready_.insert(programs.begin(), programs.end());
}

const render::RendererProgram& Renderers::program(const exporter::Exporter& exporter) {
  const std::array wanted = {&exporter};
  require(wanted);
  const std::lock_guard lock(mutex_);
  return ready_.at(&exporter);
}

}  // namespace wold::work
