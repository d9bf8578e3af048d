#include "render/renderer.h"

namespace wold::render {

const ExternalProgram& external_program(Renderer renderer) {
  static constexpr ExternalProgram blender = {"Blender", "blender", "WOLD_BLENDER", "--blender"};
  static constexpr ExternalProgram povray = {"POV-Ray", "povray", "WOLD_POVRAY", "--povray"};
  return renderer == Renderer::blender ? blender : povray;
}

std::string_view display_name(Renderer renderer) { return external_program(renderer).display_name; }

FoundProgram find_renderer(Renderer renderer, const std::string& chosen) {
  return find_program(external_program(renderer), chosen);
}

}  // namespace wold::render
