#include "meadow/cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "meadow/canopy_snow.h"
#include "meadow/cell_lattice.h"
#include "meadow/shrubs.h"
#include "place/view.h"
#include "scene/key_frames.h"
#include "scene/species.h"
#include "support/film_parts.h"
#include "support/grown.h"
#include "terrain/hillside.h"
#include "terrain/horizon.h"

namespace wold::meadow {
namespace {

using test::grown;

/// A meadow of 12 m: quick, and large enough for several levels.
scene::Scene small_meadow() {
  scene::Scene scene;
  scene.terrain.size_m = 12.0;
  scene.grass.patch_m = 0.5;
  scene.grass.height_m = 0.28;
  scene.grass.pixels_per_voxel = 1.0;
  scene.terrain.samples = 97;
  scene.terrain.hill_height_m = 2.0;
  scene.terrain.relief_m = 0.3;
  scene.camera.eye_m = {6.0, 0.2};
  scene.camera.target_m = {6.0, 8.0};
  return scene;
}

/// The same, seen from far above: every cell is listed, at the coarsest level.
scene::Scene from_above() {
  scene::Scene scene = small_meadow();
  scene.camera.eye_m = {6.0, 0.0};
  scene.camera.eye_height_m = 60.0;
  scene.camera.target_m = {6.0, 6.0};
  return scene;
}

std::vector<CellChoice> choices_of(const scene::Scene& scene, int frame = 2) {
  const Heightfield terrain = terrain::make_hillside(scene.terrain, scene.seed);
  return choose_cells(scene, terrain, grown(scene), test::mixtures_of(scene, terrain),
                      test::withering_of(scene, terrain), test::grass_of(scene, frame));
}

// Cells are boxes that lean; where neighbours lean away from each other one saw the ground.
TEST(Cells, LeaveNoGapsWhereTheyReach) {
  const scene::Scene scene = small_meadow();
  const WindLean wind_lean(scene.wind, {}, scene.seed);
  const Heightfield level(3, 12.0);
  const double patch_m = scene.grass.patch_m, height_m = scene.grass.height_m;
  double widest_m = 0.0;
  for (int i = 0; i < 23; ++i)
    for (int j = 0; j < 23; ++j) {
      /// Both ends of the cell at a height.
      const auto ends_m = [&](const glm::ivec2& cell, double z) {
        const landscape::CellPose pose = {cell, cell.x + 2 * cell.y,
                                          wind_lean.lean((glm::dvec2(cell) + 0.5) * patch_m)};
        const glm::dmat4 matrix =
            landscape::fit_to_ground(level, patch_m, pose, {}).world_from_cell *
            reach_to_neighbours(wind_lean, patch_m, pose, height_m);
        const glm::dvec2 a(matrix * glm::dvec4(0, 0, z, 1));
        const glm::dvec2 b(matrix * glm::dvec4(patch_m, patch_m, z, 1));
        return std::pair(glm::min(a, b), glm::max(a, b));
      };
      for (const double z : {0.0, height_m}) {
        const glm::dvec2 overlap_m(ends_m({i, j}, z).second.x - ends_m({i + 1, j}, z).first.x,
                                   ends_m({i, j}, z).second.y - ends_m({i, j + 1}, z).first.y);
        EXPECT_GE(std::min(overlap_m.x, overlap_m.y), -1e-9);
        widest_m = std::max({widest_m, overlap_m.x, overlap_m.y});
      }
    }
  EXPECT_GT(widest_m, 0.001) << "nothing leans";
  EXPECT_LT(widest_m, 0.1 * patch_m) << "cells hardly overlap";
}

// Seen from between them, neighbours that overlap were a bright seam and gaps a dark one.
TEST(Cells, ShowAsMuchBetweenThemAsWithin) {
  const scene::Scene scene = from_above();
  const double patch_m = scene.grass.patch_m, height_m = scene.grass.height_m;
  const std::vector<CellChoice> choices = choices_of(scene);
  ASSERT_EQ(choices.size(), 24U * 24U);
  /// Both ends of a cell along x at a height.
  const auto ends_m = [&](const CellChoice& choice, double z) {
    const glm::dmat4 matrix = choice.parts.at(0).world_from_cell * choice.reach;
    const double a = (matrix * glm::dvec4(0, 0, z, 1)).x;
    const double b = (matrix * glm::dvec4(patch_m, patch_m, z, 1)).x;
    return std::pair(std::min(a, b), std::max(a, b));
  };
  int apart = 0;
  for (std::size_t k = 0; k + 1 < choices.size(); ++k) {
    if (k % 24 == 23) continue;
    const auto overlap_m = [&](double z) {
      return ends_m(choices[k], z).second - ends_m(choices[k + 1], z).first;
    };
    const double mean_m = 0.5 * (overlap_m(0.0) + overlap_m(height_m));
    const bool lean_apart = overlap_m(height_m) < overlap_m(0.0);
    if (lean_apart) {
      EXPECT_NEAR(mean_m, 0.0, 1e-4 * patch_m);  // a row bends on the way to its next cell
    }
    apart += lean_apart ? 1 : 0;
  }
  EXPECT_GT(apart, 50);
}

TEST(Cells, NeighboursDiffer) {
  const scene::Scene scene = from_above();
  const std::vector<CellChoice> choices = choices_of(scene);
  ASSERT_EQ(choices.size(), 24U * 24U);
  std::set<std::array<int, 3>> uses, all;
  for (const CellChoice& choice : choices) {
    uses.insert({choice.lod, choice.variant, choice.turn});
    for (int variant = 0; variant < scene.grass.variants; ++variant)
      for (int turn = 0; turn < turns_of_lod(scene, choice.lod); ++turn)
        all.insert({choice.lod, variant, turn});
  }
  EXPECT_EQ(uses, all);
  EXPECT_GE(all.size(), 8U);
  const CellLattice lattice(scene);
  for (std::size_t k = 0; k < choices.size(); ++k) {
    if (k % 24 > 0) {
      EXPECT_NE(choices[k].variant, choices[k - 1].variant);
    }
    for (const double east : {0.03, 0.5, 0.97}) {
      const glm::ivec2 below =
          lattice.cell_at(lattice.ground(choices[k].cell).place_m({east, -0.1}));
      if (below.y < 0 || below.x < 0 || below.x > 23) continue;
      EXPECT_NE(choices[k].variant,
                choices[static_cast<std::size_t>(24 * below.y + below.x)].variant);
    }
  }
}

TEST(Cells, SingleVariantStillTurns) {
  scene::Scene scene = from_above();
  scene.grass.variants = 1;
  const std::vector<CellChoice> choices = choices_of(scene);
  int alike = 0;
  for (std::size_t k = 0; k < choices.size(); ++k)
    alike += k % 24 > 0 && choices[k].turn == choices[k - 1].turn;
  EXPECT_LT(alike, 0.02 * static_cast<double>(choices.size()));  // those below count, too
}

TEST(Cells, DependOnNothingButTheCell) {
  std::map<std::pair<int, int>, CellChoice> all;
  for (const CellChoice& choice : choices_of(from_above()))
    all[{choice.cell.x, choice.cell.y}] = choice;
  const ThreadLimit one(1);
  const std::vector<CellChoice> seen = choices_of(small_meadow());
  const scene::Scene scene = small_meadow();
  EXPECT_LT(seen.size(), all.size());
  for (const CellChoice& choice : seen) {
    const CellChoice& other = all.at({choice.cell.x, choice.cell.y});
    const int voxels = scene.grass.lods[static_cast<std::size_t>(choice.lod)];
    EXPECT_EQ(choice.variant, other.variant);
    EXPECT_EQ(choice.key_frame, other.key_frame);
    EXPECT_EQ(choice.turn, other.turn % turns_of_lod(voxels));
  }
}

TEST(Cells, LevelsAreAsFineAsThePixels) {
  const scene::Scene scene = small_meadow();
  const Heightfield terrain = terrain::make_hillside(scene.terrain, scene.seed);
  const landscape::Camera camera = place::resolved_camera(scene.camera, terrain, 0.0);
  const double pixels_per_radian =
      scene.render.size_px[0] / (2.0 * std::tan(27.5 * std::numbers::pi / 180.0));
  std::set<int> levels;
  for (const CellChoice& choice :
       choose_cells(scene, terrain, grown(scene), test::mixtures_of(scene, terrain),
                    test::withering_of(scene, terrain), test::grass_of(scene, 1))) {
    levels.insert(choice.lod);
    const glm::dvec4 centre =
        choice.parts.front().world_from_cell * glm::dvec4(0.25, 0.25, 0.14, 1);
    const double distance_m = glm::length(glm::dvec3(centre) - camera.eye_m);
    const auto pixels = [&](int level) {
      return 0.5 / scene.grass.lods[static_cast<std::size_t>(level)] * pixels_per_radian /
             distance_m;
    };
    if (choice.lod > 0) {
      EXPECT_LT(pixels(choice.lod), 1.12);
    }
    if (choice.lod < 3) {
      EXPECT_GT(pixels(choice.lod + 1), 0.9);
    }
  }
  EXPECT_GE(levels.size(), 3U);
}

// "auto": blades exactly where even the finest voxel is too large on the picture, up to the jitter
// of a tenth; they stand as the finest level's texels do, unturned.
TEST(Cells, AutoDrawsBladesWhereTheFinestLevelIsTooCoarse) {
  scene::Scene scene = small_meadow();
  scene.render.grass = scene::GrassForm::automatic;
  const Heightfield terrain = terrain::make_hillside(scene.terrain, scene.seed);
  const place::View view(place::resolved_camera(scene.camera, terrain, 0.0),
                         scene.render.size_px[0], scene.render.size_px[1]);
  const double voxel_m = scene.grass.patch_m / scene.grass.lods.front();
  int blades = 0;
  for (const CellChoice& choice :
       choose_cells(scene, terrain, grown(scene), test::mixtures_of(scene, terrain),
                    test::withering_of(scene, terrain), test::grass_of(scene, 2))) {
    const glm::dvec2 at_m = (glm::dvec2(choice.cell) + 0.5) * scene.grass.patch_m;
    const glm::dvec3 middle_m(at_m, terrain.sample(at_m.x, at_m.y) + scene.grass.height_m / 2.0);
    const double pixels = view.pixels(voxel_m, middle_m) / scene.grass.pixels_per_voxel;
    if (pixels > 1.12) {
      EXPECT_TRUE(choice.blades);
    }
    if (pixels < 0.9) {
      EXPECT_FALSE(choice.blades);
    }
    if (choice.blades) {
      EXPECT_EQ(choice.turn, 0);
    }
    blades += choice.blades ? 1 : 0;
  }
  EXPECT_GE(blades, 3);
  scene.render.grass = scene::GrassForm::blades;
  for (const CellChoice& choice :
       choose_cells(scene, terrain, grown(scene), test::mixtures_of(scene, terrain),
                    test::withering_of(scene, terrain), test::grass_of(scene, 2)))
    EXPECT_TRUE(choice.blades);
}

TEST(Cells, KeepEveryBladeInThePicture) {
  const scene::Scene scene = small_meadow();
  const Heightfield terrain = terrain::make_hillside(scene.terrain, scene.seed);
  const landscape::Camera camera = place::resolved_camera(scene.camera, terrain, 0.0);
  std::set<std::pair<int, int>> listed;
  for (const CellChoice& choice :
       choose_cells(scene, terrain, grown(scene), test::mixtures_of(scene, terrain),
                    test::withering_of(scene, terrain), test::grass_of(scene, 1)))
    listed.insert({choice.cell.x, choice.cell.y});
  const glm::dvec3 forward = glm::normalize(camera.target_m - camera.eye_m);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double across = std::tan(27.5 * std::numbers::pi / 180.0);
  for (double x = 0.05; x < 12.0; x += 0.1)
    for (double y = 0.05; y < 12.0; y += 0.1)
      for (const double height_m : {0.0, 0.4}) {
        const glm::dvec3 to = glm::dvec3(x, y, terrain.sample(x, y) + height_m) - camera.eye_m;
        const double depth = glm::dot(to, forward);
        const bool inside = depth > 0 && std::abs(glm::dot(to, right)) < depth * across &&
                            std::abs(glm::dot(to, up)) < depth * across * 540.0 / 960.0;
        if (inside && !terrain::is_hidden(terrain, camera.eye_m, camera.eye_m + to)) {
          EXPECT_TRUE(listed.count({static_cast<int>(x / 0.5), static_cast<int>(y / 0.5)}));
        }
      }
}

TEST(Weathering, DithersAboutTheWantedDegree) {
  scene::Scene scene = from_above();
  scene.ageing.frames = {0.0, 0.375, 0.39, 1.0};
  scene.ageing.age_spread = 0.0;
  const auto mean_degree = [&](int frame) {
    double sum = 0.0;
    const std::vector<CellChoice> choices = choices_of(scene, frame);
    for (const CellChoice& choice : choices)
      sum += scene::key_frames(scene)[static_cast<std::size_t>(choice.key_frame)];
    return sum / static_cast<double>(choices.size());
  };
  EXPECT_EQ(mean_degree(1), 0.0);
  EXPECT_NEAR(mean_degree(2), 0.375, 0.005);  // 576 cells between 0.333 and 0.417
  EXPECT_EQ(mean_degree(4), 1.0);
  const std::vector<CellChoice> before = choices_of(scene, 2);
  const std::vector<CellChoice> after = choices_of(scene, 3);
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_GE(after[k].key_frame, before[k].key_frame);  // nothing grows green again
}

// Each pair of variant and key frame is a volume in memory: one variant at most is between two.
TEST(Weathering, VariantsPassToTheNextKeyFrameOneAfterTheOther) {
  scene::Scene scene = from_above();
  scene.ageing.age_spread = 0.0;
  scene.ageing.frames = {0.34, 0.36, 0.375, 0.40};  // key frames at 0.333 and 0.417
  for (int frame = 1; frame <= 4; ++frame) {
    std::set<std::pair<int, int>> shown;
    for (const CellChoice& choice : choices_of(scene, frame))
      shown.insert({choice.variant, choice.key_frame});
    EXPECT_LE(shown.size(), static_cast<std::size_t>(scene.grass.variants) + 1);
  }
}

TEST(Weathering, VariesSmoothlyAndNotAtTheEnds) {
  scene::Scene scene = small_meadow();
  scene.ageing.frames = {0.0, 0.5, 1.0};
  const place::Withering withering =
      test::withering_of(scene, terrain::make_hillside(scene.terrain, scene.seed));
  double largest = 0.0;
  double step_squares = 0.0;
  for (int k = 0; k < 200; ++k) {
    const glm::dvec2 at_m(0.5 * k, 3.0);
    EXPECT_EQ(withering.at(at_m, 1), 0.0);
    EXPECT_EQ(withering.at(at_m, 3), 1.0);
    const double here = withering.at(at_m, 2);
    EXPECT_LE(std::abs(here - 0.5), scene.ageing.age_spread);
    const double step = withering.at(at_m + glm::dvec2(0.5, 0.0), 2) - here;
    step_squares += step * step / 200.0;
    largest = std::max(largest, std::abs(here - 0.5));
  }
  EXPECT_GT(largest, 0.5 * scene.ageing.age_spread);
  EXPECT_LT(std::sqrt(step_squares), 0.2 * scene.ageing.age_spread);  // between neighbouring cells
}

TEST(Cells, RefuseAFrameThatDoesNotExist) {
  EXPECT_THROW(choices_of(small_meadow(), 4), InputError);
}

// Cells wear the two levels of snow around the frame's, in the mean as much as it.
TEST(ChooseCells, SnowIsDitheredBetweenTwoLevels) {
  scene::Scene scene = from_above();
  for (const CellChoice& choice : choices_of(scene)) EXPECT_EQ(choice.snow, 0);
  scene.weather.temperature_c = -3.0;
  scene.weather.precipitation_mm_h = 0.6;
  scene.weather.earlier_h = 1.0;
  const double wanted = grass::PatchState::level_of(test::grass_of(scene, 2).snow);
  ASSERT_GT(wanted, 1.0);
  const std::vector<CellChoice> choices = choices_of(scene);
  double sum = 0.0;
  for (const CellChoice& choice : choices) {
    EXPECT_LT(std::abs(choice.snow - wanted), 1.0);
    sum += choice.snow;
  }
  // Three standard deviations of the mean of draws between two neighbours.
  EXPECT_NEAR(sum / static_cast<double>(choices.size()), wanted,
              1.5 / std::sqrt(static_cast<double>(choices.size())));
}

// Cells stand for what grows at their middle: the second species on the part of the ground that its
// cover says, whole variants of each mixture, and nothing else changes.
TEST(Cells, StandForTheMixtureAtTheirMiddle) {
  scene::Scene scene = from_above();
  scene.species.resize(2);
  const std::vector<CellChoice> plain = choices_of(scene);
  scene.species[1].habitat.cover = 0.4;
  scene.species[1].habitat.feature_m = 0.5;
  const std::vector<CellChoice> choices = choices_of(scene);
  const Heightfield terrain = terrain::make_hillside(scene.terrain, scene.seed);
  const place::MixtureField mixtures(scene, terrain);
  ASSERT_EQ(choices.size(), plain.size());
  int with = 0;
  std::set<int> variants;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const glm::dvec2 at_m = CellLattice(scene).ground(choices[i].cell).middle_m;
    EXPECT_EQ(scene::mixture_number(scene, choices[i].variant), mixtures.at(at_m));
    EXPECT_EQ(choices[i].variant % scene.grass.variants, plain[i].variant);
    EXPECT_EQ(choices[i].state(), plain[i].state());
    with += scene::mixture_number(scene, choices[i].variant) == 0;
    variants.insert(choices[i].variant);
  }
  EXPECT_NEAR(with / static_cast<double>(choices.size()), 0.4, 0.06);
  EXPECT_EQ(static_cast<int>(variants.size()), scene::patch_count(scene));
}

// Voxels are to cover as many pixels in a large shrub as in what stands around it.
TEST(Cells, LargeShrubsAreFiner) {
  scene::Scene scene = from_above();
  scene.grass.lods = {126, 62, 30};
  scene.species.resize(2);
  scene.species[1].plant.crown_m = 0.4;
  scene.species[1].habitat.cover = 0.4;
  int others = 0;
  for (const double pixels : {0.2, 0.4, 0.8, 1.6}) {
    scene.grass.pixels_per_voxel = pixels;
    int lod_around = 0;
    for (const CellChoice& choice : choices_of(scene)) {
      if (!choice.beside_cell) {
        lod_around = choice.lod;  // is listed first
        continue;
      }
      const double size = glm::length(glm::dvec2(choice.beside_cell->world_from_patch[0]));
      EXPECT_TRUE(size > 1.0 ? choice.lod <= lod_around : choice.lod >= lod_around) << size;
      others += choice.lod != lod_around;
    }
  }
  EXPECT_GT(others, 20);
}

// What grows around shrubs stands on their cell, and they beside it: anywhere in it, in sizes of
// their own, whole on the terrain.
TEST(Cells, HaveTheirShrubsBesideThem) {
  scene::Scene scene = from_above();
  scene.species.resize(2);
  scene.species[1].plant.crown_m = 0.4;
  scene.species[1].habitat.cover = 0.4;
  scene.species[1].habitat.feature_m = 0.5;
  const std::vector<CellChoice> choices = choices_of(scene);
  std::set<std::pair<int, int>> on_cells;
  std::vector<double> sizes;
  glm::dvec2 shift_m(0.0), square_m2(0.0);
  const double patch_m = scene.grass.patch_m;
  for (const CellChoice& choice : choices) {
    const int mixture = scene::mixture_number(scene, choice.variant);
    const std::pair<int, int> cell(choice.cell.x, choice.cell.y);
    if (!choice.beside_cell) {
      EXPECT_EQ(mixture, 1);  // without the shrub
      EXPECT_TRUE(on_cells.insert(cell).second);
      continue;
    }
    EXPECT_EQ(mixture, 0);
    EXPECT_TRUE(on_cells.contains(cell));
    EXPECT_EQ(choice.reach, glm::dmat4(1.0));
    const glm::dmat4& world_from_cell = choice.beside_cell->world_from_patch;
    sizes.push_back(glm::length(glm::dvec2(world_from_cell[0])));
    const glm::dvec2 middle_m(world_from_cell * glm::dvec4(0.5 * patch_m, 0.5 * patch_m, 0, 1));
    const glm::dvec2 off_m = middle_m - CellLattice(scene).ground(choice.cell).middle_m;
    shift_m += off_m;
    square_m2 += off_m * off_m;
    for (const glm::dvec2 corner : {glm::dvec2(0.0), glm::dvec2(patch_m)}) {
      const glm::dvec4 at_m = world_from_cell * glm::dvec4(corner, 0, 1);
      EXPECT_GT(std::min(at_m.x, at_m.y), -1e-9);
      EXPECT_LT(std::max(at_m.x, at_m.y), scene.terrain.size_m + 1e-9);
    }
  }
  const auto shrubs = static_cast<double>(sizes.size());
  EXPECT_NEAR(shrubs / static_cast<double>(on_cells.size()), 0.4, 0.06);
  for (scene.seed = 2; scene.seed <= 5; ++scene.seed)
    for (const CellChoice& choice : choices_of(scene))
      if (choice.beside_cell)
        sizes.push_back(glm::length(glm::dvec2(choice.beside_cell->world_from_patch[0])));
  double covered = 0.0;
  for (const double size : sizes) covered += size * size / static_cast<double>(sizes.size());
  EXPECT_NEAR(covered, 1.0, 0.06);
  EXPECT_NEAR(*std::ranges::min_element(sizes), smallest_shrub, 0.02);
  EXPECT_NEAR(*std::ranges::max_element(sizes), largest_shrub, 0.02);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(shift_m[axis] / shrubs, 0.0, 0.1 * patch_m);
    EXPECT_NEAR(square_m2[axis] / shrubs, patch_m * patch_m / 12.0, 0.2 * patch_m * patch_m / 12.0);
  }
}

}  // namespace
}  // namespace wold::meadow
