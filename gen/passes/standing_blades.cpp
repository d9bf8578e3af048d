#include "passes/standing_blades.h"

#include <array>
#include <cmath>

#include "core/parallel.h"
#include "landscape/triangle.h"

namespace wold::passes {

StandingBlades::StandingBlades(const landscape::Landscape& landscape)
    : landscape_(landscape), meshes_(), cells_({}) {
  for (const landscape::BladeMesh& mesh : landscape.blade_meshes)
    meshes_.push_back(mesh_of(*mesh.tubes));
  std::vector<landscape::Box> boxes;
  for (const landscape::BladeCell& cell : landscape.blade_cells) {
    boxes.push_back(box_of(cell));
    cell_from_world_.push_back(glm::inverse(cell.world_from_cell));
  }
  cells_ = landscape::BoxTree(boxes);
}

StandingBlades::Mesh StandingBlades::mesh_of(const Tubes& tubes) {
  std::vector<Triangle> triangles;
  std::vector<landscape::Box> boxes;
  const auto corners = static_cast<std::size_t>(tubes.corners);
  const auto rings = static_cast<std::size_t>(tubes.rings);
  const auto add = [&](std::size_t ring, const std::array<glm::vec3, 3>& corners_m) {
    triangles.push_back({corners_m, ring});
    boxes.emplace_back();
    for (const glm::vec3& corner_m : corners_m) boxes.back().add(corner_m);
  };
  for (std::size_t ring = 0; ring + 1 < tubes.rings_of_all(); ++ring) {
    if ((ring + 1) % rings == 0) continue;  // the next one is another tube's
    for (std::size_t c = 0; c < corners; ++c) {
      const auto corner_m = [&](std::size_t of_ring, std::size_t number) {
        return tubes.vertices_m[of_ring * corners + number % corners];
      };
      add(ring, {corner_m(ring, c), corner_m(ring, c + 1), corner_m(ring + 1, c + 1)});
      add(ring, {corner_m(ring, c), corner_m(ring + 1, c + 1), corner_m(ring + 1, c)});
    }
  }
  landscape::BoxTree tree(boxes);
  return {std::move(triangles), std::move(tree)};
}

/// In world space. Rounding to floats may not leave anything out.
landscape::Box StandingBlades::box_of(const landscape::BladeCell& cell) const {
  constexpr float rounding_m = 1e-3F;
  const Mesh& mesh = meshes_[static_cast<std::size_t>(cell.mesh)];
  landscape::Box box;
  if (mesh.tree.is_empty()) return box;
  const landscape::Box& inner = mesh.tree.box();
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at_m((corner & 1) != 0 ? inner.high.x : inner.low.x,
                          (corner & 2) != 0 ? inner.high.y : inner.low.y,
                          (corner & 4) != 0 ? inner.high.z : inner.low.z);
    const glm::vec3 world_m(glm::dvec3(cell.world_from_cell * glm::dvec4(at_m, 1.0)));
    box.add(world_m - rounding_m);
    box.add(world_m + rounding_m);
  }
  return box;
}

BladeHit StandingBlades::look(const glm::dvec3& eye_m, const glm::dvec3& direction,
                              double end_m) const {
  BladeHit hit;
  const Triangle* met = nullptr;
  double nearest_m = end_m;
  cells_.follow(eye_m, direction, end_m, [&](std::uint32_t number) {
    const glm::dvec3 start(cell_from_world_[number] * glm::dvec4(eye_m, 1.0));
    const glm::dvec3 along = glm::dmat3(cell_from_world_[number]) * direction;
    const Mesh& mesh = meshes_[static_cast<std::size_t>(landscape_.blade_cells[number].mesh)];
    mesh.tree.follow(start, along, nearest_m, [&](std::uint32_t triangle) {
      const double at_m = landscape::meeting_m(start, along, mesh.triangles[triangle].corners_m);
      if (at_m < nearest_m) {
        nearest_m = hit.distance_m = at_m;
        hit.cell = static_cast<int>(number);
        met = &mesh.triangles[triangle];
      }
      return nearest_m;
    });
    return nearest_m;
  });
  if (!met) return hit;
  hit.ring = met->ring;
  const glm::dmat3 from_world(cell_from_world_[static_cast<std::size_t>(hit.cell)]);
  hit.normal = glm::normalize(glm::transpose(from_world) * landscape::across(met->corners_m));
  if (glm::dot(hit.normal, direction) > 0.0) hit.normal = -hit.normal;
  return hit;
}

}  // namespace wold::passes
