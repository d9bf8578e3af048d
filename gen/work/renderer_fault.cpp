#include "work/renderer_fault.h"

#include <fmt/format.h>

namespace wold::work {
namespace {

/// What of the scene is missing in pictures without volumes.
std::string volumes_of(const SceneNeeds& needs) {
  if (needs.grass_volumes && needs.cloud_volumes) return "grass and clouds";
  return needs.grass_volumes ? "grass" : "clouds";
}

/// How the scene goes without volumes.
std::string without_volumes(const SceneNeeds& needs) {
  std::string way = needs.grass_volumes ? "draw the grass as blades by --grass blades" : "";
  if (needs.cloud_volumes)
    way += fmt::format("{}paint the clouds by body = \"sheet\" in [[clouds]]",
                       way.empty() ? "" : " and ");
  return way;
}

std::string no_volumes(const render::RendererProgram& program, const SceneNeeds& needs) {
  return fmt::format(
      "{} shows no volumes, which this scene's {} would be drawn as; take {}, or {}; nothing was "
      "rendered",
      described(program), volumes_of(needs), other_build(*program.kind), without_volumes(needs));
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
