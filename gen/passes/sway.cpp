#include "passes/sway.h"

#include "core/parallel.h"
#include "landscape/cell_parts.h"

namespace wold::passes {
namespace {

/// How the plane rises on which a cell stands, metres to each metre east and north.
glm::dvec2 rise_of(const glm::dmat4& world_from_cell) {
  return glm::dvec2(world_from_cell[0].z, world_from_cell[1].z) *
         glm::inverse(glm::dmat2(world_from_cell));
}

}  // namespace

template <class Cells>
std::vector<Sway::Shear> Sway::shears(const Cells& cells, const GroundFacts& facts) {
  if (!facts.more_lean) return {};
  std::vector<Shear> shears(cells.size());
  parallel_for_blocks(cells.size(), [&](std::size_t i) {
    const glm::dmat4& placed = cells[i].world_from_cell;
    const glm::dvec2 more = facts.more_lean(cells[i].origin.cell);
    shears[i] = {glm::inverse(placed),
                 landscape::size_of(placed) * glm::dvec3(more, glm::dot(rise_of(placed), more))};
  });
  return shears;
}

Sway::Sway(const landscape::Landscape& landscape, const GroundFacts& facts)
    : cells_(shears(landscape.cells, facts)), blade_cells_(shears(landscape.blade_cells, facts)) {}

glm::dvec3 Sway::of(const SeenPlace& seen) const {
  const bool is_blade = seen.thing == SeenPlace::Thing::blade;
  if (!is_blade && seen.thing != SeenPlace::Thing::volume) return glm::dvec3(0.0);
  const std::vector<Shear>& shears = is_blade ? blade_cells_ : cells_;
  if (shears.empty()) return glm::dvec3(0.0);
  const Shear& shear = shears[static_cast<std::size_t>(seen.cell)];
  return (shear.cell_from_world * glm::dvec4(seen.at_m, 1.0)).z * shear.per_height;
}

}  // namespace wold::passes
