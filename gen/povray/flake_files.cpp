#include "povray/flake_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/files.h"
#include "core/image.h"
#include "povray/text.h"

namespace wold::povray {
namespace {

namespace fs = std::filesystem;
using landscape::Flake;
using landscape::Flakes;

// As for blades of grass: a mesh has to be written in the scene's unit.
constexpr float units_per_m = 100.0F;

/// POV-Ray gives opacity to textures, not to triangles: flakes share one per picture and step.
constexpr int opacity_steps = 255;

/// A picture and an opacity in steps, at least one: what is faint must not be lost.
using Look = std::pair<int, int>;

Look look_of(const Flake& flake) {
  const int step = static_cast<int>(std::lround(flake.opacity * opacity_steps));
  return {flake.picture, std::clamp(step, 1, opacity_steps)};
}

/// The looks in use, numbered in their order.
std::map<Look, int> looks_of(const Flakes& flakes) {
  std::map<Look, int> looks;
  for (const Flake& flake : flakes.flakes) looks[look_of(flake)] = 0;
  int next = 0;
  for (auto& [look, number] : looks) number = next++;
  return looks;
}

void append_pictures(std::string& text, const Flakes& flakes) {
  fmt::format_to(std::back_inserter(text), "Wold_flake_pictures({})\n", flakes.pictures.size());
  for (std::size_t i = 0; i < flakes.pictures.size(); ++i)
    fmt::format_to(std::back_inserter(text), "Wold_flake_picture({}, {})\n", i,
                   literal(flakes.pictures[i].name));
}

void append_vertices(std::string& text, const Flakes& flakes, const glm::dvec3& eye_m) {
  fmt::format_to(std::back_inserter(text), "  vertex_vectors {{ {}\n", 4 * flakes.flakes.size());
  for (const Flake& flake : flakes.flakes) {
    for (const glm::vec3& corner_m : corners_from(eye_m, flake)) {
      const glm::vec3 at = corner_m * units_per_m;
      fmt::format_to(std::back_inserter(text), ",<{:.6g},{:.6g},{:.6g}>", at.x, at.y, at.z);
    }
    text += '\n';
  }
  text += "  }\n  uv_vectors { 4, <0,0>,<1,0>,<1,1>,<0,1> }\n";
}

void append_textures(std::string& text, const std::map<Look, int>& looks) {
  fmt::format_to(std::back_inserter(text), "  texture_list {{ {}\n", looks.size());
  for (const auto& [look, number] : looks)
    fmt::format_to(std::back_inserter(text), ",Wold_flake_texture({}, {})\n", look.first,
                   look.second);
  text += "  }\n";
}

void append_triangles(std::string& text, const Flakes& flakes, const std::map<Look, int>& looks) {
  fmt::format_to(std::back_inserter(text), "  face_indices {{ {}\n", 2 * flakes.flakes.size());
  std::size_t corner = 0;
  for (const Flake& flake : flakes.flakes) {
    fmt::format_to(std::back_inserter(text), ",<{0},{1},{2}>,{4},<{0},{2},{3}>,{4}\n", corner,
                   corner + 1, corner + 2, corner + 3, looks.at(look_of(flake)));
    corner += 4;
  }
  fmt::format_to(std::back_inserter(text), "  }}\n  uv_indices {{ {}\n", 2 * flakes.flakes.size());
  for (std::size_t i = 0; i < flakes.flakes.size(); ++i) text += ",<0,1,2>,<0,2,3>\n";
  text += "  }\n";
}

void write_pictures(const std::vector<landscape::FlakePicture>& pictures, const fs::path& folder) {
  make_folder(folder);
  for (const landscape::FlakePicture& picture : pictures) {
    const fs::path path = folder / (picture.name + ".png");
    if (!fs::exists(path)) write_image(path, picture.opacity, PixelFormat::uint8);
  }
}

}  // namespace

void write_flakes(const Flakes& flakes, const glm::dvec3& eye_m, const fs::path& frame_folder,
                  const fs::path& pictures_folder) {
  const fs::path path = frame_folder / "flakes.inc";
  if (flakes.flakes.empty()) {
    fs::remove(path);
    return;
  }
  write_pictures(flakes.pictures, pictures_folder);
  const std::map<Look, int> looks = looks_of(flakes);
  std::string text = fmt::format("// Flakes: centimetres from the eye, z up.\n{}", include_begin);
  append_pictures(text, flakes);
  text += "#declare Wold_flakes = mesh2 {\n";
  append_vertices(text, flakes, eye_m);
  append_textures(text, looks);
  append_triangles(text, flakes, looks);
  text += "}\n";
  write_file(path, text += include_end);
}

}  // namespace wold::povray
