#pragma once

#include <filesystem>
#include <string_view>

namespace wold::render {

/// The external programs that make pictures.
enum class Renderer { blender, povray };

/// "Blender" or "POV-Ray", for people.
std::string_view display_name(Renderer renderer);

/// The program: $WOLD_BLENDER or $WOLD_POVRAY when set, otherwise the first `blender` or `povray`
/// on the PATH. Throws RendererError that names the Debian package to install when there is none.
std::filesystem::path find_renderer(Renderer renderer);

}  // namespace wold::render
