#include "work/renderer_fault.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace wold::work {
namespace {

/// A thing that is missing in pictures without volumes, and how the scene goes without it.
struct Volumes {
  bool needed;
  const char* what;
  const char* without;
};

std::string no_volumes(const render::RendererProgram& program, const SceneNeeds& needs) {
  std::vector<const char*> things, ways;
  for (const Volumes& volumes :
       {Volumes{needs.grass_volumes, "grass", "draw the grass as blades by --grass blades"},
        Volumes{needs.cloud_volumes, "clouds",
                "paint the clouds by body = \"sheet\" in [[clouds]]"},
        Volumes{needs.blown_snow, "blown snow", "leave it out by --set snow_cover.blowing=0"}}) {
    if (!volumes.needed) continue;
    things.push_back(volumes.what);
    ways.push_back(volumes.without);
  }
  return fmt::format(
      "{} shows no volumes, which this scene's {} would be drawn as; take {}, or {}; nothing was "
      "rendered",
      described(program), fmt::join(things, " and "), other_build(*program.kind),
      fmt::join(ways, " and "));
}

std::string no_fog(const render::RendererProgram& program) {
  return fmt::format(
      "{} shows no homogeneous medium, which far snow in this scene's air would be drawn as; take "
      "{}; nothing was rendered",
      described(program), other_build(*program.kind));
}

std::string no_device(const render::RendererProgram& program) {
  return fmt::format(
      "render.device = \"gpu\": {} finds no graphics card that it can compute on; install the "
      "card's driver, take {}, or set render.device to \"cpu\" or \"auto\"; nothing was rendered",
      described(program), other_build(*program.kind));
}

}  // namespace

std::string other_build(const render::Renderer& renderer) {
  return fmt::format("another build{} by {} or {}", renderer.better_builds, renderer.program.option,
                     renderer.program.variable);
}

std::string fault_of(const render::RendererProgram& program, const render::Capabilities& can,
                     const scene::Scene& scene) {
  const SceneNeeds needs = needs_of(scene);
  if (needs_volumes(needs) && !can.volumes) return no_volumes(program, needs);
  if (needs.fog && !can.fog) return no_fog(program);
  if (program.kind->has_devices && scene.render.device == scene::Device::gpu && can.devices.empty())
    return no_device(program);
  return {};
}

}  // namespace wold::work
