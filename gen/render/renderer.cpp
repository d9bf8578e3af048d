#include "render/renderer.h"

#include "render/program.h"

namespace wold::render {
namespace {

const ExternalProgram& program(Renderer renderer) {
  static constexpr ExternalProgram blender = {"Blender", "blender", "WOLD_BLENDER"};
  static constexpr ExternalProgram povray = {"POV-Ray", "povray", "WOLD_POVRAY"};
  return renderer == Renderer::blender ? blender : povray;
}

}  // namespace

std::string_view display_name(Renderer renderer) { return program(renderer).display_name; }

std::filesystem::path find_renderer(Renderer renderer) { return find_program(program(renderer)); }

}  // namespace wold::render
