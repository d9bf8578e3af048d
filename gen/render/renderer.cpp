#include "render/renderer.h"

namespace wold::render {

std::string_view display_name(const Renderer& renderer) { return renderer.program.display_name; }

FoundProgram find_renderer(const Renderer& renderer, const std::string& chosen) {
  return find_program(renderer.program, chosen);
}

}  // namespace wold::render
