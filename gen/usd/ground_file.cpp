#include "usd/ground_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.h"
#include "usd/mesh_text.h"
#include "usd/text.h"

namespace wold::usd {
namespace {

namespace fs = std::filesystem;
using landscape::GroundDetail;
using landscape::Landscape;

/// The terrain's lines along an axis, and those where finer pictures end.
std::vector<double> lines_m(const Landscape& landscape, int axis) {
  const Heightfield& terrain = landscape.terrain;
  std::vector<double> lines;
  for (int i = 0; i < terrain.samples(); ++i) lines.push_back(terrain.place_m(i, i)[axis]);
  const double first = lines.front(), last = lines.back();
  for (const GroundDetail& detail : landscape.ground_details)
    for (const double at_m : {detail.corner_m[axis], detail.corner_m[axis] + detail.map.size_m()})
      if (at_m > first && at_m < last) lines.push_back(at_m);
  std::ranges::sort(lines);
  const double same_m = 1e-6 * terrain.step_m();
  const auto near = [&](double a, double b) { return b - a < same_m; };
  lines.erase(std::unique(lines.begin(), lines.end(), near), lines.end());
  return lines;
}

struct GroundMesh {
  std::vector<glm::vec3> points_m;
  std::vector<glm::vec3> normals;
  std::vector<glm::dvec2> st;
  std::vector<std::size_t> counts;                ///< of each face's corners
  std::vector<std::size_t> corners;               ///< face by face
  std::vector<std::vector<std::size_t>> subsets;  ///< faces of each detail
};

glm::dvec3 normal_at(const Heightfield& terrain, const glm::dvec2& at_m) {
  const double step_m = terrain.step_m();
  const auto rise = [&](const glm::dvec2& along) {
    const glm::dvec2 low = glm::max(at_m - along * step_m, terrain.corner_m());
    const glm::dvec2 high = glm::min(at_m + along * step_m, terrain.corner_m() + terrain.size_m());
    return double{terrain.sample(high.x, high.y) - terrain.sample(low.x, low.y)} /
           glm::dot(high - low, along);
  };
  return glm::normalize(glm::dvec3(-rise({1, 0}), -rise({0, 1}), 1.0));
}

void add_point(const Heightfield& terrain, const glm::dvec2& at_m, GroundMesh& mesh) {
  mesh.points_m.emplace_back(glm::vec2(at_m), terrain.sample(at_m.x, at_m.y));
  mesh.normals.emplace_back(normal_at(terrain, at_m));
  mesh.st.push_back((at_m - terrain.corner_m()) / terrain.size_m());
}

/// The finest picture of the ground at a place.
std::optional<std::size_t> detail_at(const std::vector<GroundDetail>& details,
                                     const glm::dvec2& at_m) {
  for (std::size_t i = details.size(); i-- > 0;)
    if (Square{details[i].corner_m, details[i].map.size_m()}.contains(at_m)) return i;
  return std::nullopt;
}

/// Each face by the picture of its first corner. A corner's normal is the mean of its faces'.
void add_boulders(const Landscape& landscape, GroundMesh& mesh) {
  const Heightfield& terrain = landscape.terrain;
  const landscape::RaisedGround& boulders = landscape.boulders;
  const std::size_t first = mesh.points_m.size();
  for (const glm::vec3& from_origin_m : boulders.points_m) {
    const glm::dvec3 at_m = boulders.origin_m + glm::dvec3(from_origin_m);
    mesh.points_m.emplace_back(at_m);
    mesh.normals.emplace_back(0.0F);
    mesh.st.push_back((glm::dvec2(at_m) - terrain.corner_m()) / terrain.size_m());
  }
  for (const glm::uvec3& corners : boulders.triangles) {
    const glm::vec3& a = boulders.points_m[corners.x];
    const glm::vec3 normal =
        glm::cross(boulders.points_m[corners.y] - a, boulders.points_m[corners.z] - a);
    if (const auto detail =
            detail_at(landscape.ground_details, glm::dvec2(boulders.origin_m) + glm::dvec2(a)))
      mesh.subsets[*detail].push_back(mesh.counts.size());
    mesh.counts.push_back(3);
    for (int k = 0; k < 3; ++k) {
      mesh.corners.push_back(first + corners[k]);
      mesh.normals[first + corners[k]] += normal;
    }
  }
  for (std::size_t i = first; i < mesh.normals.size(); ++i)
    mesh.normals[i] = glm::normalize(mesh.normals[i]);
}

GroundMesh ground_mesh(const Landscape& landscape) {
  const std::vector<double> x_m = lines_m(landscape, 0), y_m = lines_m(landscape, 1);
  GroundMesh mesh;
  mesh.subsets.resize(landscape.ground_details.size());
  for (const double y : y_m)
    for (const double x : x_m) add_point(landscape.terrain, {x, y}, mesh);
  for (std::size_t j = 0; j + 1 < y_m.size(); ++j)
    for (std::size_t i = 0; i + 1 < x_m.size(); ++i) {
      const std::size_t corner = j * x_m.size() + i;
      const glm::dvec2 middle_m = 0.5 * glm::dvec2(x_m[i] + x_m[i + 1], y_m[j] + y_m[j + 1]);
      if (const auto detail = detail_at(landscape.ground_details, middle_m))
        mesh.subsets[*detail].push_back(mesh.counts.size());
      mesh.counts.push_back(4);
      mesh.corners.insert(mesh.corners.end(),
                          {corner, corner + 1, corner + 1 + x_m.size(), corner + x_m.size()});
    }
  add_boulders(landscape, mesh);
  return mesh;
}

std::string index_text(std::size_t i) { return fmt::format_int(i).str(); }

std::string subset_text(std::size_t number, const std::vector<std::size_t>& faces) {
  return fmt::format(
      "\n"
      "    def GeomSubset \"detail_{}\"\n"
      "    {{\n"
      "        uniform token elementType = \"face\"\n"
      "        uniform token familyName = \"materialBind\"\n"
      "        int[] indices = {}\n"
      "    }}\n",
      number, array(faces, index_text));
}

std::string layer_text(const GroundMesh& mesh) {
  const auto millimetres = [](const glm::vec3& v) { return rounded(glm::dvec3(v), 4); };
  const auto thousandths = [](const glm::vec3& v) { return rounded(glm::dvec3(v), 3); };
  const auto place = [](const glm::dvec2& at) { return rounded(at, 7); };
  std::string text = fmt::format(
      "#usda 1.0\n"
      "(\n"
      "    defaultPrim = \"Ground\"\n"
      "    metersPerUnit = 1\n"
      "    upAxis = \"Z\"\n"
      ")\n"
      "\n"
      "def Mesh \"Ground\"\n"
      "{{\n"
      "    uniform bool doubleSided = 1\n"
      "    float3[] extent = {}\n"
      "    int[] faceVertexCounts = {}\n"
      "    int[] faceVertexIndices = {}\n"
      "    normal3f[] normals = {} (\n"
      "        interpolation = \"vertex\"\n"
      "    )\n"
      "    point3f[] points = {}\n"
      "    texCoord2f[] primvars:st = {} (\n"
      "        interpolation = \"vertex\"\n"
      "    )\n"
      "    uniform token subdivisionScheme = \"none\"\n"
      "    uniform token subsetFamily:materialBind:familyType = \"nonOverlapping\"\n",
      extent_text(mesh.points_m), array(mesh.counts, index_text), array(mesh.corners, index_text),
      array(mesh.normals, thousandths), array(mesh.points_m, millimetres), array(mesh.st, place));
  for (std::size_t i = 0; i < mesh.subsets.size(); ++i) text += subset_text(i + 1, mesh.subsets[i]);
  return text + "}\n";
}

}  // namespace

std::string write_ground(const Landscape& landscape, const fs::path& folder) {
  const std::string text = layer_text(ground_mesh(landscape));
  std::string name = fmt::format("ground_{}.usda", content_hash(text));
  update_file(folder / name, text);
  return name;
}

PicturePlace place_in(const Heightfield& terrain, const Square& square, int samples) {
  // Values lie on the square's border, pixels within a picture's.
  const double to_pixels = (samples - 1.0) / samples;
  const glm::dvec2 from_corner_m = terrain.corner_m() - square.corner_m;
  return {glm::dvec2(to_pixels * terrain.size_m() / square.size_m),
          to_pixels * from_corner_m / square.size_m + 0.5 / samples};
}

}  // namespace wold::usd
