#include "passes/sway.h"

#include <gtest/gtest.h>

namespace wold::passes {
namespace {

using landscape::Landscape;

/// As grass stands on ground that rises by `rise` to the east and north: a quarter-turn about the
/// middle of a patch of half a metre, sheared and narrowed as rows want it, leaning over, as large
/// as `size` says.
glm::dmat4 placed(const glm::dvec2& lean, const glm::dvec2& rise, double size = 1.0) {
  glm::dmat4 world_from_cell(1.0);
  constexpr double shear = 0.2, across = 0.8;  // its area stays
  world_from_cell[0] = across * glm::dvec4(0.0, 1.0, rise.y, 0.0);
  world_from_cell[1] = glm::dvec4(-1.0, -shear, -rise.x - shear * rise.y, 0.0) / across;
  world_from_cell[2] = {lean.x, lean.y, 1.0 + glm::dot(rise, lean), 0.0};
  for (int axis = 0; axis < 3; ++axis) world_from_cell[axis] *= size;
  world_from_cell[3] = {7.5, 3.0, 1.25, 1.0};
  return world_from_cell;
}

SeenPlace seen_at(const glm::dvec3& at_m, SeenPlace::Thing thing) {
  SeenPlace seen;
  seen.thing = thing;
  seen.at_m = at_m;
  return seen;
}

TEST(Sway, LeadsToWhereTheCellShowsItWhenItLeansMore) {
  const glm::dvec2 rise(0.3, -0.2), lean(0.1, 0.05), more(-0.04, 0.11);
  const glm::dvec4 in_cell_m(0.12, 0.4, 0.25, 1.0);
  GroundFacts facts;
  facts.more_lean = [&](const glm::ivec2&) { return more; };
  for (const double size : {1.0, 1.25}) {
    Landscape landscape;
    landscape.cells = {{.world_from_cell = placed(lean, rise, size)}};
    landscape.blade_cells = {{.world_from_cell = placed(lean, rise, size)}};
    const Sway sway(landscape, facts);
    const glm::dvec3 now_m(placed(lean, rise, size) * in_cell_m);
    const glm::dvec3 next_m(placed(lean + more, rise, size) * in_cell_m);
    for (const auto thing : {SeenPlace::Thing::volume, SeenPlace::Thing::blade})
      EXPECT_LT(glm::distance(now_m + sway.of(seen_at(now_m, thing)), next_m), 1e-12);
    for (const auto thing : {SeenPlace::Thing::ground, SeenPlace::Thing::nothing})
      EXPECT_EQ(sway.of(seen_at(now_m, thing)), glm::dvec3(0.0));
  }
}

}  // namespace
}  // namespace wold::passes
