#include "render/probe.h"

namespace wold::render {

Capabilities probe(const RendererProgram& program, const Interrupted& interrupted) {
  return program.kind->probe(program, interrupted);
}

std::string probe_content(const RendererProgram& program) {
  return program.kind->probe_content(program);
}

}  // namespace wold::render
