#include "povray/blade_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "core/files.h"
#include "core/image.h"
#include "povray/text.h"

namespace wold::povray {
namespace {

namespace fs = std::filesystem;

// The scene's unit (templates/povray/scene.pov). POV-Ray moves rays, not meshes: a mesh has to be
// written in the unit whose tolerances it can bear.
constexpr float units_per_m = 100.0F;

/// Of NAME.inc. The number is that of the layout.
constexpr std::string_view first_line = "// Blades of grass, layout 2: centimetres, z up.\n";

void append_vertices(std::string& text, const Tubes& tubes) {
  fmt::format_to(std::back_inserter(text), "  vertex_vectors {{ {}\n", tubes.vertices_m.size());
  for (const glm::vec3& vertex : tubes.vertices_m) {
    const glm::vec3 at = vertex * units_per_m;
    fmt::format_to(std::back_inserter(text), ",<{:.5g},{:.5g},{:.5g}>\n", at.x, at.y, at.z);
  }
  text += "  }\n";
}

/// Pixel centres: what the picture says of a ring holds for all its corners.
void append_picture_places(std::string& text, const Tubes& tubes) {
  fmt::format_to(std::back_inserter(text), "  uv_vectors {{ {}\n", tubes.vertices_m.size());
  const auto count = static_cast<double>(tubes.count());
  for (std::size_t tube = 0; tube < tubes.count(); ++tube)
    for (int ring = 0; ring < tubes.rings; ++ring)
      for (int corner = 0; corner < tubes.corners; ++corner)
        fmt::format_to(std::back_inserter(text), ",<{:.6g},{:.6g}>\n", (ring + 0.5) / tubes.rings,
                       1.0 - (static_cast<double>(tube) + 0.5) / count);
  text += "  }\n";
}

void append_triangles(std::string& text, const Tubes& tubes) {
  const std::vector<std::uint32_t> quads = quad_corners(tubes);
  fmt::format_to(std::back_inserter(text), "  face_indices {{ {}\n", quads.size() / 2);
  for (std::size_t i = 0; i < quads.size(); i += 4)
    fmt::format_to(std::back_inserter(text), ",<{0},{1},{2}>,<{0},{2},{3}>\n", quads[i],
                   quads[i + 1], quads[i + 2], quads[i + 3]);
  text += "  }\n";
}

Image radiance_picture(const Tubes& tubes) {
  Image picture(tubes.rings, static_cast<int>(tubes.count()), 3);
  for (std::size_t i = 0; i < tubes.radiance.size(); ++i) {
    const int ring = static_cast<int>(i) % tubes.rings;
    const int tube = static_cast<int>(i) / tubes.rings;
    std::copy_n(&tubes.radiance[i].x, 3, picture.pixel(ring, tube));
  }
  return picture;
}

}  // namespace

void write_blades(const landscape::BladeMesh& mesh, const fs::path& folder) {
  const fs::path picture = folder / (mesh.name + ".exr");
  if (!fs::exists(picture)) write_image(picture, radiance_picture(*mesh.tubes), PixelFormat::half);
  const fs::path text_file = folder / (mesh.name + ".inc");
  if (fs::exists(text_file) && read_file(text_file).starts_with(first_line)) return;
  std::string text = fmt::format("{}{}#declare Wold_mesh = mesh2 {{\n", first_line, include_begin);
  append_vertices(text, *mesh.tubes);
  append_picture_places(text, *mesh.tubes);
  append_triangles(text, *mesh.tubes);
  text += "}\n";
  write_file(text_file, text += include_end);
}

}  // namespace wold::povray
