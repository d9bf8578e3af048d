#include "work/renderers.h"

#include <algorithm>

#include "core/error.h"
#include "core/interrupt.h"
#include "render/probe_cache.h"
#include "work/renderer_fault.h"

namespace wold::work {
namespace {

/// Whether anything depends on what the renderer can do.
bool has_to_be_probed(const scene::Scene& scene, render::Renderer renderer) {
  const SceneNeeds needs = needs_of(scene);
  return needs_volumes(needs) || needs.fog ||
         (renderer == render::Renderer::blender && scene.render.device != scene::Device::cpu);
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
  if (program.kind != render::Renderer::blender || scene.render.device != scene::Device::automatic)
    return;
  if (can.devices.empty())
    progress.say(
        "render.device = \"auto\": Blender found no graphics card and takes the processor");
}

}  // namespace

const std::string& chosen_program(const Job& job, render::Renderer renderer) {
  return renderer == render::Renderer::blender ? job.blender : job.povray;
}

void Renderers::check(const render::RendererProgram& program) const {
  if (!has_to_be_probed(job_.scene, program.kind)) return;
  const render::Capabilities can = capabilities(program, job_.scene);
  if (const std::string fault = fault_of(program, can, job_.scene); !fault.empty())
    throw RendererError(fault);
  say_what_it_computes_on(program, can, job_.scene, progress_);
}

void Renderers::require(const std::vector<render::Renderer>& wanted) {
  const std::lock_guard lock(mutex_);
  std::map<render::Renderer, render::FoundProgram> found;
  for (const render::Renderer renderer : wanted)
    if (!ready_.contains(renderer))
      found[renderer] = render::find_renderer(renderer, chosen_program(job_, renderer));
  std::vector<render::RendererProgram> programs;
  for (const auto& [renderer, program] : found)
    programs.push_back(render::recognise(renderer, program, interrupted));
  for (const render::RendererProgram& program : programs) check(program);
  for (render::RendererProgram& program : programs) ready_[program.kind] = std::move(program);
}

const render::RendererProgram& Renderers::program(render::Renderer renderer) {
  require({renderer});
  const std::lock_guard lock(mutex_);
  return ready_.at(renderer);
}

}  // namespace wold::work
