#include "passes/sway.h"

#include "core/parallel.h"

namespace wold::passes {

template <class Cells>
std::vector<Sway::Shear> Sway::shears(const Cells& cells, const GroundFacts& facts) {
  if (!facts.more_lean) return {};
  std::vector<Shear> shears(cells.size());
  parallel_for_blocks(cells.size(), [&](std::size_t i) {
    const glm::dmat4& placed = cells[i].world_from_cell;
    const glm::dvec2 more = facts.more_lean(cells[i].origin.cell);
    // Cells are turned about the vertical: how the ground rises to the east and north.
    const double size = glm::length(glm::dvec2(placed[0]));
    const glm::dvec2 rise =
        (placed[0].z * glm::dvec2(placed[0]) + placed[1].z * glm::dvec2(placed[1])) / (size * size);
    shears[i] = {glm::inverse(placed), size * glm::dvec3(more, glm::dot(rise, more))};
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
