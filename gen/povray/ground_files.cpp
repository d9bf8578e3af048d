#include "povray/ground_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

#include "core/df3.h"
#include "core/files.h"
#include "core/image.h"
#include "core/rough_picture.h"
#include "povray/text.h"

namespace wold::povray {
namespace fs = std::filesystem;
namespace {

void append_vertices(std::string& text, const Heightfield& terrain) {
  const int n = terrain.samples();
  fmt::format_to(std::back_inserter(text), "  vertex_vectors {{ {}\n", n * n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      fmt::format_to(std::back_inserter(text), ",<{:.7g},{:.7g},{:.7g}>{}", i * terrain.step_m(),
                     j * terrain.step_m(), terrain.at(i, j), i == n - 1 ? "\n" : "");
  text += "  }\n";
}

void append_triangles(std::string& text, int n) {
  fmt::format_to(std::back_inserter(text), "  face_indices {{ {}\n", 2 * (n - 1) * (n - 1));
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const int corner = j * n + i;
      fmt::format_to(std::back_inserter(text), ",<{0},{1},{3}>,<{0},{3},{2}>{4}", corner,
                     corner + 1, corner + n, corner + n + 1, i == n - 2 ? "\n" : "");
    }
  text += "  }\n";
}

/// The beginning of a file that declares Wold_<stem>_mesh.
std::string mesh_begin(std::string_view what, std::string_view stem) {
  return fmt::format(
      "// The {} triangles: metres, x east, y north, z up.\n{}"
      "#declare Wold_{}_mesh = mesh2 {{\n",
      what, include_begin, stem);
}

/// Ends such a file and writes it as <stem>_<hash>.inc; returns the file's name.
std::string write_mesh(std::string text, std::string_view stem, const fs::path& folder) {
  text += "}\n";
  text += include_end;
  std::string name = fmt::format("{}_{}.inc", stem, content_hash(text));
  update_file(folder / name, text);
  return name;
}

constexpr float smallest_scale = std::numeric_limits<float>::min();

void write_slice(const FactorMap& factor, float largest, const fs::path& path) {
  write_file(path, [&](std::ostream& out) {
    write_df3(out, {factor.samples(), factor.samples(), 1}, factor.values(), largest, 16);
  });
}

FactorMap channel_of(const ColourMap& map, int c) {
  FactorMap channel(map.samples(), map.square());
  std::ranges::transform(map.values(), channel.values().begin(),
                         [c](const glm::vec3& value) { return value[c]; });
  return channel;
}

}  // namespace

std::string write_terrain(const Heightfield& terrain, const fs::path& folder) {
  std::string text = mesh_begin("ground's", "terrain");
  append_vertices(text, terrain);
  append_triangles(text, terrain.samples());
  return write_mesh(std::move(text), "terrain", folder);
}

std::string write_boulders(const landscape::RaisedGround& boulders, const fs::path& folder) {
  std::string text = mesh_begin("boulders'", "boulders");
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "  vertex_vectors {{ {}", boulders.points_m.size());
  for (const glm::vec3& at_m : boulders.points_m)
    fmt::format_to(out, ",\n<{:.7g},{:.7g},{:.7g}>", at_m.x, at_m.y, at_m.z);
  fmt::format_to(out, "\n  }}\n  face_indices {{ {}", boulders.triangles.size());
  for (const glm::uvec3& corners : boulders.triangles)
    fmt::format_to(out, ",\n<{},{},{}>", corners.x, corners.y, corners.z);
  text += "\n  }\n";
  return write_mesh(std::move(text), "boulders", folder);
}

float write_factor(const FactorMap& factor, const fs::path& path) {
  const float largest =
      std::max(*std::max_element(factor.values().begin(), factor.values().end()), smallest_scale);
  write_slice(factor, largest, path);
  return largest;
}

std::vector<std::string> light_files(const std::string& stem, std::size_t number) {
  const std::string of_map = number == 0 ? stem : fmt::format("{}_{}", stem, number);
  return {of_map + "_r.df3", of_map + "_g.df3", of_map + "_b.df3"};
}

void remove_light(const fs::path& folder, const std::string& stem, std::size_t number) {
  bool removed = true;
  for (; removed; ++number) {
    removed = false;
    for (const std::string& name : light_files(stem, number))
      removed = fs::remove(folder / name) || removed;
  }
}

glm::vec3 write_light(std::span<const ColourMap> maps, const fs::path& folder,
                      const std::string& stem) {
  glm::vec3 largest(smallest_scale);
  for (const ColourMap& map : maps)
    for (const glm::vec3& light : map.values()) largest = glm::max(largest, light);
  for (std::size_t number = 0; number < maps.size(); ++number) {
    const std::vector<std::string> names = light_files(stem, number);
    for (int c = 0; c < 3; ++c)
      write_slice(channel_of(maps[number], c), largest[c],
                  folder / names[static_cast<std::size_t>(c)]);
  }
  remove_light(folder, stem, maps.size());
  return largest;
}

void write_map_picture(const ColourMap& map, const fs::path& path) {
  const int n = map.samples();
  Image picture(n, n, 3);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const glm::vec3 value = map.at(i, j);
      std::copy_n(&value[0], 3, picture.pixel(i, n - 1 - j));
    }
  write_rough_picture(path, picture);
}

std::string write_ground_details(const landscape::Landscape& scene, const fs::path& folder) {
  const auto path = [&](std::size_t number) {
    return folder / fmt::format("ground_detail_{}.exr", number);
  };
  const std::size_t count = scene.ground_details.size();
  for (std::size_t stale = count + 1; fs::remove(path(stale));) ++stale;
  if (count == 0) return {};
  std::string text = fmt::format("#declare Wold_ground_detail = array[{}][5] {{\n", count);
  const ColourMap* coarser = &scene.ground;
  for (std::size_t i = 0; i < count; ++i) {
    const landscape::GroundDetail& detail = scene.ground_details[i];
    write_map_picture(detail.map, path(i + 1));
    text += fmt::format("  {{ {}, {}, {}, {}, {} }},\n", number(detail.corner_m.x),
                        number(detail.corner_m.y), detail.map.samples(),
                        number(detail.map.step_m()), number(soft_border_m(*coarser, detail)));
    coarser = &detail.map;
  }
  return text + "}  // west and south edge, samples, step, soft border: metres\n";
}

}  // namespace wold::povray
