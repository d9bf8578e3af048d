#include "meadow/cell_lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "landscape/cell_parts.h"
#include "landscape/footprint.h"

namespace wold::meadow {
namespace {

scene::Scene scene_of(double patch_m) {
  scene::Scene scene;
  scene.grass.patch_m = patch_m;
  return scene;
}

landscape::Footprint footprint(const CellLattice& lattice, const glm::ivec2& cell, int turn,
                               double patch_m) {
  landscape::CellPose pose = {.cell = cell, .turn = turn};
  lattice.place_patch(pose);
  const Heightfield level(3, 100.0);
  return {landscape::fit_to_ground(level, patch_m, pose, {}).world_from_cell, {}, patch_m};
}

// Every place belongs to one cell, but for slivers between rows that bend.
TEST(CellLattice, CoversTheGroundOnce) {
  for (const double patch_m : {0.3, 0.6}) {
    const CellLattice lattice(scene_of(patch_m));
    constexpr int places = 20000;
    int none = 0, several = 0, others = 0;
    for (int k = 0; k < places; ++k) {
      const glm::dvec2 at_m =
          20.0 + 40.0 * glm::fract(1.0 * k * glm::dvec2(0.7548776662466927, 0.5698402909980532));
      const glm::ivec2 cell = lattice.cell_at(at_m);
      int owners = 0;
      for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i)
          owners += footprint(lattice, cell + glm::ivec2(i, j), k % 4, patch_m).contains(at_m);
      none += owners == 0;
      several += owners > 1;
      others += !footprint(lattice, cell, k % 4, patch_m).contains(at_m);
    }
    EXPECT_LT(none / (1.0 * places), 0.005);
    EXPECT_LT(several / (1.0 * places), 0.0002);
    EXPECT_LT(others / (1.0 * places), 0.006);
  }
}

/// How much a patch's plants line up where cells have these phases, in sides of a cell: 1 all of
/// them, 0 none.
template <class Phase>
double lined_up(int cells, const Phase& phase) {
  std::complex<double> sum = 0.0;
  for (int k = 0; k < cells; ++k) sum += std::polar(1.0, 2.0 * std::numbers::pi * phase(k));
  return std::abs(sum) / cells;
}

// Flowers of a meadow stood in rows that one saw as far as single ones.
TEST(CellLattice, HasNoStraightRows) {
  const CellLattice lattice(scene_of(0.6));
  const auto to_the_north = [&](int k) { return lattice.ground({40, k}).middle_m.x / 0.6; };
  const auto to_the_east = [&](int k) { return lattice.ground({k, 40}).middle_m.y / 0.6; };
  EXPECT_LT(lined_up(4000, to_the_north), 0.05);
  EXPECT_LT(lined_up(4000, to_the_east), 0.3);
}

TEST(CellLattice, MovesAndShearsCellsALittle) {
  const CellLattice lattice(scene_of(0.6));
  double steepest = 0.0;
  glm::dvec2 farthest_m(0.0);
  for (int k = 0; k < 4000; ++k) {
    const glm::ivec2 cell(k % 977, k);
    landscape::CellPose pose = {.cell = cell};
    lattice.place_patch(pose);
    steepest = std::max(steepest, std::abs(pose.shear));
    farthest_m = glm::max(farthest_m, glm::abs(pose.shift_m));
    // A row's pieces meet.
    const glm::dvec2 gap_m = lattice.ground(cell + glm::ivec2(1, 0)).place_m({0.0, 0.0}) -
                             lattice.ground(cell).place_m({1.0, 0.0});
    EXPECT_NEAR(gap_m.x, 0.0, 1e-9);
    EXPECT_LT(std::abs(gap_m.y), 0.01 * 0.6);
  }
  EXPECT_LT(steepest, 0.134);
  EXPECT_GT(steepest, 0.08);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_LE(farthest_m[axis], CellLattice::max_shift * 0.6);
    EXPECT_GT(farthest_m[axis], 0.45 * 0.6);
  }
}

// Their patches go on in each other; a single one stays where it is.
TEST(CellLattice, IsOfSquaresForCoatsForeignTexelsAndOnePatch) {
  scene::Scene coat = scene_of(0.6), foreign = scene_of(0.6), single = scene_of(0.6);
  coat.ageing.fur.clumps = 8;
  foreign.grass.from_texel = "a.vdb";
  single.terrain.size_m = 1.0;
  for (const scene::Scene& scene : {coat, foreign, single}) {
    const CellLattice lattice(scene);
    const glm::dvec2 place_m = 0.6 * glm::dvec2(7.25, 9.5);
    EXPECT_LT(glm::distance(lattice.ground({7, 9}).place_m({0.25, 0.5}), place_m), 1e-12);
    EXPECT_EQ(lattice.cell_at(place_m), glm::ivec2(7, 9));
    landscape::CellPose pose = {.cell = {7, 9}};
    lattice.place_patch(pose);
    EXPECT_EQ(pose.north_stretch, 1.0);
    EXPECT_EQ(pose.shift_m, glm::dvec2(0.0));
  }
}

}  // namespace
}  // namespace wold::meadow
