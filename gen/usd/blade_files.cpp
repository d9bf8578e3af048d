#include "usd/blade_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.h"
#include "core/image.h"
#include "usd/mesh_text.h"
#include "usd/text.h"

namespace wold::usd {
namespace {

namespace fs = std::filesystem;

constexpr int decimals = 5;  // 10 um

/// Where each ring's picture is looked up, tube by tube: the first row is the upper one.
std::vector<glm::dvec2> places_in_picture(const Tubes& tubes) {
  std::vector<glm::dvec2> places;
  for (std::size_t tube = 0; tube < tubes.count(); ++tube)
    for (int ring = 0; ring < tubes.rings; ++ring)
      places.emplace_back((ring + 0.5) / tubes.rings, 1.0 - (static_cast<double>(tube) + 0.5) /
                                                                static_cast<double>(tubes.count()));
  return places;
}

/// The ring that each vertex belongs to.
std::vector<std::size_t> ring_of_vertices(const Tubes& tubes) {
  std::vector<std::size_t> rings;
  for (std::size_t vertex = 0; vertex < tubes.vertices_m.size(); ++vertex)
    rings.push_back(vertex / static_cast<std::size_t>(tubes.corners));
  return rings;
}

glm::dvec3 mean_of(const std::vector<glm::vec3>& colours) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3& colour : colours) sum += glm::dvec3(colour);
  return colours.empty() ? sum : sum / static_cast<double>(colours.size());
}

std::string mesh_text(const Tubes& tubes) {
  const std::vector<std::uint32_t> corners = quad_corners(tubes);
  const auto position = [](const glm::vec3& at_m) { return rounded(glm::dvec3(at_m), decimals); };
  const auto place = [](const glm::dvec2& at) { return rounded(at, 6); };
  const auto index = [](auto i) { return fmt::format_int(i).str(); };
  return fmt::format(
      "def Mesh \"mesh\"\n"
      "{{\n"
      "    uniform bool doubleSided = 1\n"
      "    float3[] extent = {}\n"
      "    int[] faceVertexCounts = {}\n"
      "    int[] faceVertexIndices = {}\n"
      "    point3f[] points = {}\n"
      "    color3f[] primvars:displayColor = [{}]\n"
      "    texCoord2f[] primvars:st = {} (\n"
      "        interpolation = \"vertex\"\n"
      "    )\n"
      "    int[] primvars:st:indices = {}\n"
      "    uniform token subdivisionScheme = \"none\"\n"
      "}}\n",
      extent_text(tubes.vertices_m), quad_counts(corners.size() / 4), array(corners, index),
      array(tubes.vertices_m, position),
      rounded(mean_of(tubes.reflectance.empty() ? tubes.radiance : tubes.reflectance), 4),
      array(places_in_picture(tubes), place), array(ring_of_vertices(tubes), index));
}

std::string layer_text(const Tubes& tubes) {
  return "#usda 1.0\n"
         "(\n"
         "    defaultPrim = \"Blades\"\n"
         "    doc = \"Blades of one patch in cell space: x and y along its sides, z up.\"\n"
         "    metersPerUnit = 1\n"
         "    upAxis = \"Z\"\n"
         ")\n"
         "\n"
         "def Xform \"Blades\"\n"
         "{\n" +
         indented(mesh_text(tubes)) + "}\n";
}

Image picture_of(const Tubes& tubes, const std::vector<glm::vec3>& colours) {
  Image picture(tubes.rings, static_cast<int>(tubes.count()), 3);
  for (std::size_t i = 0; i < colours.size(); ++i)
    std::copy_n(&colours[i].x, 3, picture.values.data() + 3 * i);
  return picture;
}

std::vector<glm::vec3> scattered_by(const Tubes& tubes) {
  std::vector<glm::vec3> all = tubes.reflectance;
  std::ranges::transform(all, tubes.transmittance, all.begin(), std::plus());
  return all;
}

}  // namespace

bool has_reflectance(const landscape::BladeMesh& mesh) {
  const Tubes& tubes = *mesh.tubes;
  return tubes.reflectance.size() == tubes.rings_of_all() &&
         tubes.transmittance.size() == tubes.rings_of_all();
}

fs::path blades_layer(const std::string& name) { return name + ".usda"; }
fs::path blades_radiance(const std::string& name) { return name + "_radiance.exr"; }
fs::path blades_reflectance(const std::string& name) { return name + "_reflectance.exr"; }

std::vector<fs::path> blade_files(const landscape::BladeMesh& mesh, const fs::path& folder) {
  std::vector<fs::path> files = {folder / blades_layer(mesh.name),
                                 folder / blades_radiance(mesh.name)};
  if (has_reflectance(mesh)) files.push_back(folder / blades_reflectance(mesh.name));
  return files;
}

void write_blades(const landscape::BladeMesh& mesh, const fs::path& folder) {
  const Tubes& tubes = *mesh.tubes;
  const auto write_once = [&](const fs::path& name, const std::vector<glm::vec3>& colours) {
    if (!fs::exists(folder / name))
      write_image(folder / name, picture_of(tubes, colours), PixelFormat::half);
  };
  write_once(blades_radiance(mesh.name), tubes.radiance);
  if (has_reflectance(mesh)) write_once(blades_reflectance(mesh.name), scattered_by(tubes));
  const fs::path layer = folder / blades_layer(mesh.name);
  if (!fs::exists(layer)) write_file(layer, layer_text(tubes));
}

}  // namespace wold::usd
