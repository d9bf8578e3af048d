#include "mitsuba/leaf_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "core/random.h"

namespace wold::mitsuba {
namespace {

namespace fs = std::filesystem;

using std::numbers::pi;

/// Where a ring's picture is looked up.
glm::vec2 uv_of(const Tubes& tubes, std::size_t tube, int ring) {
  return {(static_cast<double>(ring) + 0.5) / tubes.rings,
          (static_cast<double>(tube) + 0.5) / static_cast<double>(tubes.count())};
}

/// A ring's centre and where its first corner, and the place a quarter round from there, lie from
/// it: the mean and the first wave of its corners.
struct Ring {
  glm::dvec3 centre_m{0.0};
  glm::dvec3 first_m{0.0};
  glm::dvec3 quarter_m{0.0};
};

Ring ring_of(const Tubes& tubes, std::size_t number) {
  const auto corners = static_cast<std::size_t>(tubes.corners);
  Ring ring;
  for (std::size_t corner = 0; corner < corners; ++corner) {
    const glm::dvec3 at_m(tubes.vertices_m[number * corners + corner]);
    const double angle = 2.0 * pi * static_cast<double>(corner) / tubes.corners;
    ring.centre_m += at_m / static_cast<double>(corners);
    ring.first_m += at_m * (2.0 * math::cos(angle) / tubes.corners);
    ring.quarter_m += at_m * (2.0 * math::sin(angle) / tubes.corners);
  }
  return ring;
}

bool lets_light_through(const Tubes& tubes, std::size_t tube) {
  const auto first = tubes.transmittance.begin() + static_cast<std::ptrdiff_t>(tube) * tubes.rings;
  return std::any_of(first, first + tubes.rings,
                     [](const glm::vec3& fraction) { return fraction != glm::vec3(0.0F); });
}

void add_ribbon(const Tubes& tubes, std::size_t tube, Mesh& mesh) {
  const double roll = pi * random_uniform({0, key_of("leaf"), tube, key_of("roll")});
  // A quarter of the outline of corners that are 1 away from the centre.
  const double half_width = 0.5 * tubes.corners * math::sin(pi / tubes.corners);
  const auto begin = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int step = 0; step < tubes.rings; ++step) {
    const auto number =
        tube * static_cast<std::size_t>(tubes.rings) + static_cast<std::size_t>(step);
    const Ring ring = ring_of(tubes, number);
    const glm::dvec3 half_m =
        half_width * (math::cos(roll) * ring.first_m + math::sin(roll) * ring.quarter_m);
    for (const double side : {-1.0, 1.0})
      mesh.vertices.push_back({glm::vec3(ring.centre_m + side * half_m), uv_of(tubes, tube, step)});
  }
  for (std::uint32_t lower = begin; lower + 2 < mesh.vertices.size(); lower += 2)
    mesh.add_quad({lower, lower + 1, lower + 3, lower + 2});
}

void add_tube(const Tubes& tubes, std::size_t tube, Mesh& mesh) {
  const auto corners = static_cast<std::uint32_t>(tubes.corners);
  const auto begin = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::size_t from =
      tube * static_cast<std::size_t>(tubes.rings) * static_cast<std::size_t>(corners);
  for (int step = 0; step < tubes.rings; ++step)
    for (std::uint32_t corner = 0; corner < corners; ++corner)
      mesh.vertices.push_back(
          {tubes.vertices_m[from + static_cast<std::size_t>(step) * corners + corner],
           uv_of(tubes, tube, step)});
  for (std::uint32_t step = 0; step + 1 < static_cast<std::uint32_t>(tubes.rings); ++step)
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
      const std::uint32_t lower = begin + step * corners, next = (corner + 1) % corners;
      mesh.add_quad(
          {lower + corner, lower + next, lower + corners + next, lower + corners + corner});
    }
}

Image picture_of(const Tubes& tubes, const std::vector<glm::vec3>& fractions) {
  Image picture(tubes.rings, static_cast<int>(tubes.count()), 3);
  for (std::size_t i = 0; i < fractions.size(); ++i)
    std::copy_n(&fractions[i].x, 3, picture.values.data() + 3 * i);
  return picture;
}

void require_shades(const landscape::BladeMesh& mesh) {
  const Tubes& tubes = *mesh.tubes;
  if (tubes.reflectance.size() == tubes.rings_of_all() &&
      tubes.transmittance.size() == tubes.rings_of_all())
    return;
  throw InputError(
      fmt::format("{}: found radiance alone, expected reflectance and transmittance; Mitsuba shows "
                  "render.grass = \"texels\", \"blades\" or \"auto\"",
                  mesh.name));
}

}  // namespace

Mesh leaf_mesh(const Tubes& tubes) {
  Mesh mesh;
  for (std::size_t tube = 0; tube < tubes.count(); ++tube)
    lets_light_through(tubes, tube) ? add_ribbon(tubes, tube, mesh) : add_tube(tubes, tube, mesh);
  return mesh;
}

std::vector<fs::path> leaf_files(const std::string& name, const fs::path& folder) {
  return {folder / (name + ".ply"), folder / (name + "_reflectance.exr"),
          folder / (name + "_transmittance.exr")};
}

void write_leaves(const landscape::BladeMesh& mesh, const fs::path& folder) {
  require_shades(mesh);
  const Tubes& tubes = *mesh.tubes;
  const std::vector<fs::path> files = leaf_files(mesh.name, folder);
  if (!fs::exists(files[0])) write_file(files[0], ply_bytes(leaf_mesh(tubes)));
  if (!fs::exists(files[1]))
    write_image(files[1], picture_of(tubes, tubes.reflectance), PixelFormat::half);
  if (!fs::exists(files[2]))
    write_image(files[2], picture_of(tubes, tubes.transmittance), PixelFormat::half);
}

}  // namespace wold::mitsuba
