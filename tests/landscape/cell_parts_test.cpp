#include "landscape/cell_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "core/parallel.h"
#include "core/random.h"
#include "meadow/blade_parts.h"
#include "meadow/cell_lattice.h"
#include "meadow/cells.h"
#include "place/growth.h"
#include "scene/parse.h"
#include "support/film_parts.h"
#include "support/grown.h"
#include "support/places.h"
#include "terrain/ground.h"

namespace wold::landscape {
namespace {

constexpr double patch_m = 0.5;
constexpr Part whole;

/// 6 m with a height by place, in steps of an eighth of a cell.
template <class Height>
Heightfield ground(const Height& height_m) {
  Heightfield terrain(97, 6.0);
  for (int j = 0; j < 97; ++j)
    for (int i = 0; i < 97; ++i)
      terrain.at(i, j) = static_cast<float>(height_m(terrain.place_m(i, j)));
  return terrain;
}

/// A number in [0, 1).
double uniform(std::uint64_t index, const char* purpose) {
  return random_uniform({0, key_of("parts test"), index, key_of(purpose)});
}

TEST(FitToGround, LiesOnASlopeExactly) {
  const Heightfield slope =
      ground([](const glm::dvec2& at_m) { return 0.3 * at_m.x - 0.7 * at_m.y; });
  for (int turn = 0; turn < 4; ++turn) {
    const CellPose pose = {{3 + turn, 7}, turn, {0.0, 0.0}};
    const GroundFit fit = fit_to_ground(slope, patch_m, pose, whole);
    EXPECT_LT(fit.deviation_m, 1e-6);
    EXPECT_NEAR(glm::determinant(fit.world_from_cell), 1.0, 1e-12);
    EXPECT_EQ(fit.world_from_cell[2], glm::dvec4(0, 0, 1, 0));
    const glm::dvec2 low_m = glm::dvec2(pose.cell) * patch_m;
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
      const glm::dvec4 at_m = fit.world_from_cell * glm::dvec4(corner * patch_m, 0, 1);
      EXPECT_NEAR(at_m.z, slope.sample(at_m.x, at_m.y), 1e-6);
      EXPECT_NEAR(std::abs(at_m.x - low_m.x - patch_m / 2), patch_m / 2, 1e-12);
      EXPECT_NEAR(std::abs(at_m.y - low_m.y - patch_m / 2), patch_m / 2, 1e-12);
    }
  }
}

TEST(FitToGround, ShiftsAndScales) {
  const Heightfield slope =
      ground([](const glm::dvec2& at_m) { return 0.3 * at_m.x - 0.7 * at_m.y; });
  const CellPose pose = {{5, 7}, 1, {0.2, 0.1}, {0.1, -0.3}, 1.3};
  const GroundFit fit = fit_to_ground(slope, patch_m, pose, whole);
  EXPECT_NEAR(glm::determinant(fit.world_from_cell), 1.3 * 1.3 * 1.3, 1e-12);
  EXPECT_NEAR(fit.world_from_cell[2].x, 1.3 * 0.2, 1e-12);  // leans as much
  const glm::dvec2 middle_m = (glm::dvec2(pose.cell) + 0.5) * patch_m + pose.shift_m;
  for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
    const glm::dvec4 at_m = fit.world_from_cell * glm::dvec4(corner * patch_m, 0, 1);
    EXPECT_NEAR(at_m.z, slope.sample(at_m.x, at_m.y), 1e-6);
    EXPECT_NEAR(std::abs(at_m.x - middle_m.x), 1.3 * patch_m / 2, 1e-12);
    EXPECT_NEAR(std::abs(at_m.y - middle_m.y), 1.3 * patch_m / 2, 1e-12);
  }
}

// A footprint with two sides to the north that lies on the slope, whichever way the patch is
// turned.
TEST(FitToGround, ShearsTheTurnedPatch) {
  const Heightfield slope =
      ground([](const glm::dvec2& at_m) { return 0.3 * at_m.x - 0.7 * at_m.y; });
  for (int turn = 0; turn < 4; ++turn) {
    const CellPose pose = {{5, 7}, turn, {0.2, 0.1}, {0.1, -0.3}, 1.3, 0.9, 0.25};
    const GroundFit fit = fit_to_ground(slope, patch_m, pose, whole);
    EXPECT_NEAR(size_of(fit.world_from_cell), 1.3 * std::sqrt(0.9), 1e-12);
    EXPECT_LT(fit.deviation_m, 1e-6);
    const glm::dvec2 centre_m = middle_m(pose, patch_m);
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
      const glm::dvec4 at_m = fit.world_from_cell * glm::dvec4(corner * patch_m, 0, 1);
      const glm::dvec2 off_m = glm::dvec2(at_m) - centre_m;
      EXPECT_NEAR(at_m.z, slope.sample(at_m.x, at_m.y), 1e-6);
      EXPECT_NEAR(std::abs(off_m.x), 1.3 * patch_m / 2, 1e-12);
      EXPECT_NEAR(std::abs(off_m.y - 0.25 * off_m.x), 1.3 * 0.9 * patch_m / 2, 1e-12);
    }
  }
}

TEST(FitToGround, TurnsCounterClockwise) {
  const Heightfield level(3, 2.0);
  const glm::dmat4 once =
      fit_to_ground(level, patch_m, {{1, 2}, 1, {0.0, 0.0}}, whole).world_from_cell;
  const glm::dvec4 east_edge = once * glm::dvec4(0.5, 0.25, 0.1, 1);  // goes to the north edge
  EXPECT_NEAR(east_edge.x, 0.75, 1e-12);
  EXPECT_NEAR(east_edge.y, 1.5, 1e-12);
  EXPECT_NEAR(east_edge.z, 0.1, 1e-12);
}

// The line nearest to a parabola z = c x^2 over a length leaves it by c length^2 / 8.
TEST(FitToGround, LeavesAParabolaAsFarAsItsArrow) {
  const Heightfield trough =
      ground([](const glm::dvec2& at_m) { return 0.8 * at_m.x * at_m.x + 0.2 * at_m.y; });
  for (int turn = 0; turn < 4; ++turn) {
    const GroundFit fit = fit_to_ground(trough, patch_m, {{2, 5}, turn, {0.0, 0.0}}, whole);
    EXPECT_NEAR(fit.deviation_m, 0.8 * patch_m * patch_m / 8.0, 1e-5);
  }
}

// A part of that parabola is bent as much as its width squared is less.
TEST(PartsOnGround, AreAsSmallAsCurvatureAsks) {
  const auto parts_of = [](double curvature) {
    const Heightfield trough =
        ground([&](const glm::dvec2& at_m) { return curvature * at_m.x * at_m.x; });
    return parts_on_ground(trough, patch_m, {{2, 5}, 0, {0.0, 0.0}}, 254, 0.01).size();
  };
  EXPECT_EQ(parts_of(0.0), 1U);
  EXPECT_EQ(parts_of(0.3), 1U);   // 0.94 cm
  EXPECT_EQ(parts_of(0.35), 4U);  // 1.09 cm
  EXPECT_EQ(parts_of(1.2), 4U);   // 3.75 cm
  EXPECT_EQ(parts_of(1.4), 16U);  // 4.38 cm
}

// Every place of the patch belongs to one part; borders lie between voxels, where the hulls that
// Blender builds of blocks of eight reach no farther than they must.
TEST(PartsOnGround, TileThePatchBetweenItsVoxels) {
  const Heightfield bumps = ground([](const glm::dvec2& at_m) {
    return 0.06 * std::sin(9.0 * at_m.x) * std::cos(7.0 * at_m.y) + 0.3 * at_m.x;
  });
  std::set<std::size_t> counts;
  for (const int voxels : {30, 62, 126, 254})
    for (int number = 0; number < 100; ++number) {
      const CellPose pose = {{number % 10, number / 10}, number % 4, {0.1, 0.0}};
      const auto parts = parts_on_ground(bumps, patch_m, pose, voxels, 0.01);
      counts.insert(parts.size());
      std::set<std::string> names;
      double area = 0.0;
      for (const PlacedPart& placed : parts) {
        const glm::dvec2 size = placed.part.high - placed.part.low;
        area += size.x * size.y;
        names.insert(suffix_of(placed.part));
        for (const double fraction : {placed.part.low.x, placed.part.low.y}) {
          const double border = fraction * voxels;
          EXPECT_NEAR(border, std::round(border), 1e-9);
          if (border > 0.0) {
            EXPECT_EQ(std::lround(border + 1.0) % ((voxels + 2) / 8), 0);
          }
        }
      }
      EXPECT_EQ(names.size(), parts.size());
      EXPECT_NEAR(area, 1.0, 1e-12);
      const auto index = static_cast<std::uint64_t>(number);
      const glm::dvec2 place(uniform(index, "x"), uniform(index, "y"));
      int owners = 0;
      for (const PlacedPart& placed : parts)
        owners += glm::all(glm::lessThanEqual(placed.part.low, place)) &&
                          glm::all(glm::lessThan(place, placed.part.high))
                      ? 1
                      : 0;
      EXPECT_EQ(owners, 1);
    }
  EXPECT_GE(counts.size(), 3U);
}

struct Example {
  scene::Scene scene;
  Heightfield terrain;
  std::vector<meadow::CellChoice> cells;
};

Example example(const char* name) {
  const auto file = wold::test::tests_folder() / ".." / name;
  scene::Scene scene = scene::read_scene(file);
  scene.render.size_px = {960, 540};
  const Heightfield terrain = terrain::make_ground(scene.terrain, scene.seed).heights_m;
  std::vector<meadow::CellChoice> cells = meadow::choose_cells(
      scene, terrain, place::growth_map(scene, terrain), test::mixtures_of(scene, terrain),
      test::withering_of(scene, terrain), test::grass_of(scene, 2));
  return {scene, terrain, cells};
}

// At random places of every part that is drawn, its floor and the ground as the model has it.
TEST(PartsOnGround, FollowTheGroundOfTheExamples) {
  for (const char* name : {"examples/hillside.toml", "tests/data/small_mountain.toml"}) {
    const Example in = example(name);
    ASSERT_GT(in.cells.size(), 1000U);
    std::size_t parts = 0, elsewhere = 0;
    double worst_m = 0.0;
    for (const meadow::CellChoice& cell : in.cells)
      for (const PlacedPart& placed : cell.parts)
        for (std::uint64_t i = 25 * parts++, end = i + 25; i < end; ++i) {
          const glm::dvec2 fraction(uniform(i, "x"), uniform(i, "y"));
          const glm::dvec2 in_cell_m =
              glm::mix(placed.part.low, placed.part.high, fraction) * in.scene.grass.patch_m;
          const glm::dvec4 at_m = placed.world_from_cell * glm::dvec4(in_cell_m, 0.0, 1.0);
          const double off_m = std::abs(at_m.z - in.terrain.sample(at_m.x, at_m.y));
          EXPECT_LE(off_m, 0.01 + 1e-5) << name << ", part " << parts;
          // Where rows of cells are bent it is the next one's.
          const glm::dvec2 place = meadow::CellLattice(in.scene).cell_at(glm::dvec2(at_m));
          EXPECT_LE(glm::distance(place, glm::dvec2(cell.cell)), 1.5);
          elsewhere += place != glm::dvec2(cell.cell);
          worst_m = std::max(worst_m, off_m);
        }
    EXPECT_GT(parts, in.cells.size()) << name;
    EXPECT_LT(static_cast<double>(elsewhere) / (25.0 * static_cast<double>(parts)), 0.01) << name;
    RecordProperty(name, std::to_string(worst_m));
  }
}

TEST(PartsOnGround, AreTheSameWithAnyNumberOfThreads) {
  const Example all = example("examples/hillside.toml");
  const ThreadLimit one(1);
  const Example alone = example("examples/hillside.toml");
  ASSERT_EQ(all.cells.size(), alone.cells.size());
  for (std::size_t k = 0; k < all.cells.size(); ++k) {
    ASSERT_EQ(all.cells[k].parts.size(), alone.cells[k].parts.size());
    for (std::size_t i = 0; i < all.cells[k].parts.size(); ++i) {
      EXPECT_EQ(all.cells[k].parts[i].part, alone.cells[k].parts[i].part);
      EXPECT_EQ(all.cells[k].parts[i].world_from_cell, alone.cells[k].parts[i].world_from_cell);
    }
  }
}

// A plain that slopes has the cells it always had.
TEST(PartsOnGround, EvenGroundHasNone) {
  scene::Scene scene;
  scene.terrain.size_m = 12.0;
  scene.camera.eye_m = {6.0, 0.2};
  scene.camera.target_m = {6.0, 8.0};
  Heightfield plain(25, 12.0);
  for (int j = 0; j < 25; ++j)
    for (int i = 0; i < 25; ++i) plain.at(i, j) = static_cast<float>(0.1 * i - 0.05 * j);
  const auto cells =
      meadow::choose_cells(scene, plain, test::grown(scene), test::mixtures_of(scene, plain),
                           test::withering_of(scene, plain), test::grass_of(scene, 1));
  ASSERT_GT(cells.size(), 100U);
  for (const meadow::CellChoice& cell : cells) {
    const glm::ivec2 from_border = glm::min(cell.cell, 19 - cell.cell);
    if (std::min(from_border.x, from_border.y) < 1) continue;  // may stand beyond the plain
    ASSERT_EQ(cell.parts.size(), 1U);
    EXPECT_TRUE(cell.parts.front().part.is_whole());
  }
}

/// Tubes of one triangle on random roots, some of them beside the patch; each has a colour.
BladeMesh tubes(std::size_t count) {
  Tubes tubes{2, 3, {}, {}};
  for (std::size_t tube = 0; tube < count; ++tube) {
    const glm::dvec2 root = 1.1 * glm::dvec2(uniform(tube, "x"), uniform(tube, "y")) - 0.05;
    for (const float z : {0.0F, 0.2F})
      for (const glm::vec2 corner : {glm::vec2(2, -1), {-1, 2}, {-1, -1}})
        tubes.vertices_m.emplace_back(
            glm::vec2(root * patch_m) + 0.001F * corner + glm::vec2(z, 0.0F), z);
    tubes.radiance.insert(tubes.radiance.end(), 2, glm::vec3(static_cast<float>(tube)));
  }
  return {"mesh", std::make_shared<const Tubes>(std::move(tubes))};
}

// However far its tip reaches, a blade belongs to the part it stands on.
TEST(BladeParts, HaveEveryBladeOnceByItsRoot) {
  constexpr std::size_t count = 300;
  const BladeMesh mesh = tubes(count);
  std::multiset<float> seen;
  std::set<std::string> names;
  for (const Part& quarter : quarters_of_patch(254)) {
    const BladeMesh part = meadow::part_of(mesh, patch_m, quarter);
    names.insert(part.name);
    EXPECT_GT(part.tubes->count(), count / 8);
    for (std::size_t tube = 0; tube < part.tubes->count(); ++tube) {
      const float colour = part.tubes->radiance[2 * tube].x;
      seen.insert(colour);
      const auto own = static_cast<std::size_t>(colour);
      const glm::dvec2 root = 1.1 * glm::dvec2(uniform(own, "x"), uniform(own, "y")) - 0.05;
      const glm::dvec2 inside = glm::clamp(root, 0.0, 1.0);
      EXPECT_TRUE(glm::all(glm::lessThanEqual(quarter.low, inside + 1e-5)));
      EXPECT_TRUE(glm::all(glm::lessThanEqual(inside, quarter.high + 1e-5)));
      for (std::size_t corner = 0; corner < 6; ++corner)
        EXPECT_EQ(part.tubes->vertices_m[6 * tube + corner],
                  mesh.tubes->vertices_m[6 * own + corner]);
    }
  }
  EXPECT_EQ(names.size(), 4U);
  ASSERT_EQ(seen.size(), count);
  EXPECT_EQ(std::set<float>(seen.begin(), seen.end()).size(), count);
  EXPECT_EQ(meadow::part_of(mesh, patch_m, whole).tubes, mesh.tubes);
}

}  // namespace
}  // namespace wold::landscape
