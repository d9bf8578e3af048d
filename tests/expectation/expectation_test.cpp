#include "expectation/expectation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "expectation/ground_march.h"
#include "landscape/perspective.h"
#include "support/cloudy_view.h"
#include "support/constant_meadow.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"

namespace wold::expectation {
namespace {

constexpr test::ConstantMeadow fog{.extinction = 4.0F, .width_px = 240, .height_px = 136};
const double height_m = fog.height_voxels * 0.5 / fog.voxels;

/// Level ground, all of it with grass in front of a camera that looks down on it.
landscape::Landscape level_meadow(const std::filesystem::path& folder) {
  landscape::Landscape meadow = test::constant_meadow(fog, folder);
  std::fill(meadow.terrain.values().begin(), meadow.terrain.values().end(), 0.0F);
  const int side = fog.cells_per_side;
  meadow.cells.clear();
  meadow.blade_cells.clear();
  for (int i = 0; i < side * side; ++i)
    meadow.cells.push_back(
        {glm::translate(glm::dmat4(1.0), {0.5 * (i % side), 0.5 * (i / side), 0.0}), 0});
  meadow.camera = {{1.5, -0.5, 3.0}, {1.5, 1.5, 0.0}, 30.0};
  return meadow;
}

/// A place in the middle of a tile looks so steeply down: the sine of the angle.
double sine_down(const landscape::Landscape& landscape, const ExpectedPicture& expected, int tile) {
  const glm::ivec2 size_px(landscape.width_px, landscape.height_px);
  const landscape::Perspective perspective(landscape.camera, size_px);
  const glm::dvec2 middle = (glm::dvec2(tile % expected.tiles.x, tile / expected.tiles.x) + 0.5) *
                            glm::dvec2(size_px) / glm::dvec2(expected.tiles);
  return -perspective.direction(middle).z;
}

/// Beer and Lambert through grass `high_m` high: of the ground so much is seen.
double through(double high_m, double sine, double extinction = double{fog.extinction}) {
  return std::exp(-extinction * high_m / sine);
}

/// Checks every tile of a meadow that lets `left(sine)` of the ground through.
template <class Left>
void expect_meadow(const landscape::Landscape& meadow, const Left& left) {
  const ExpectedPicture expected = expected_picture(meadow);
  ASSERT_EQ(expected.things.size(), 1U);
  EXPECT_EQ(expected.things[0].name, "grass");
  EXPECT_EQ(expected.things[0].tiles.size(),
            static_cast<std::size_t>(expected.tiles.x * expected.tiles.y));
  for (const ExpectedTile& tile : expected.things[0].tiles) {
    const double ground = left(sine_down(meadow, expected, tile.tile));
    const double seen = double{fog.radiance} * (1.0 - ground) + double{fog.ground} * ground;
    EXPECT_NEAR(double{tile.with.g}, meadow.exposure_gain * seen, 0.004) << tile.tile;
    EXPECT_NEAR(double{tile.without.g}, meadow.exposure_gain * double{fog.ground}, 1e-6);
  }
}

TEST(Expectation, GrassFollowsBeerAndLambert) {
  const test::TemporaryFolder folder("expectation");
  expect_meadow(level_meadow(folder.path()), [](double sine) { return through(height_m, sine); });
}

// Rows that each begin elsewhere and rise to the east cover the ground as squares do.
TEST(Expectation, ShearedRowsHideAsSquaresDo) {
  const test::TemporaryFolder folder("expectation_rows");
  landscape::Landscape meadow = level_meadow(folder.path());
  meadow.cells.clear();
  constexpr double shear = 0.15;
  for (int row = -6; row < 12; ++row)
    for (int column = -6; column < 12; ++column) {
      const double east_m = 0.5 * column + 0.07 * row;
      const glm::dvec4 corner_m(east_m, 0.5 * row + shear * east_m, 0.0, 1.0);
      glm::dmat4 placed(glm::dvec4(1.0, shear, 0.0, 0.0), {0, 1, 0, 0}, {0, 0, 1, 0}, corner_m);
      if (column % 2 == 0) {  // turned by a quarter
        const glm::dvec4 west = -placed[0];
        placed[3] += 0.5 * placed[0];
        placed[0] = placed[1];
        placed[1] = west;
      }
      meadow.cells.push_back({placed, 0});
    }
  expect_meadow(meadow, [](double sine) { return through(height_m, sine); });
}

// As shrubs and the grass around them.
TEST(Expectation, WhatStandsOnOnePlaceHidesTogether) {
  const test::TemporaryFolder folder("expectation_together");
  landscape::Landscape meadow = level_meadow(folder.path());
  const std::vector<landscape::Cell> once = meadow.cells;
  meadow.cells.insert(meadow.cells.end(), once.begin(), once.end());
  expect_meadow(meadow,
                [](double sine) { return through(height_m, sine, 2.0 * double{fog.extinction}); });
}

TEST(Expectation, ThinGrassIsThinner) {
  const test::TemporaryFolder folder("expectation_thin");
  landscape::Landscape meadow = level_meadow(folder.path());
  std::fill(meadow.extinction_factor.values().begin(), meadow.extinction_factor.values().end(),
            0.5F);
  expect_meadow(meadow,
                [](double sine) { return through(height_m, sine, 0.5 * double{fog.extinction}); });
}

// Snow is ground: two thirds of the grass stand under it.
TEST(Expectation, BuriedGrassIsNotSeen) {
  const test::TemporaryFolder folder("expectation_snow");
  landscape::Landscape meadow = level_meadow(folder.path());
  const auto snow_m = static_cast<float>(2.0 / 3.0 * height_m);
  std::fill(meadow.terrain.values().begin(), meadow.terrain.values().end(), snow_m);
  expect_meadow(meadow, [](double sine) { return through(height_m / 3.0, sine); });
}

// Leaning over: as much longer the way through it is, as much thinner the grass is along it.
TEST(Expectation, SlopedCellsAreSheared) {
  const test::TemporaryFolder folder("expectation_slope");
  landscape::Landscape meadow = level_meadow(folder.path());
  constexpr double slope = 0.4;  // up to the north
  for (int j = 0; j < meadow.terrain.samples(); ++j)
    for (int i = 0; i < meadow.terrain.samples(); ++i)
      meadow.terrain.at(i, j) = static_cast<float>(slope * meadow.terrain.place_m(i, j).y);
  for (landscape::Cell& cell : meadow.cells) {
    cell.world_from_cell[1].z = slope;
    cell.world_from_cell[3].z = slope * cell.world_from_cell[3].y;
  }
  const landscape::Perspective perspective(meadow.camera, {meadow.width_px, meadow.height_px});
  const ExpectedPicture expected = expected_picture(meadow);
  ASSERT_EQ(expected.things.size(), 1U);
  for (const ExpectedTile& tile : expected.things[0].tiles) {
    const glm::dvec2 middle =
        (glm::dvec2(tile.tile % expected.tiles.x, tile.tile / expected.tiles.x) + 0.5) *
        glm::dvec2(meadow.width_px, meadow.height_px) / glm::dvec2(expected.tiles);
    const glm::dvec3 way = perspective.direction(middle);
    const double ground = through(height_m, slope * way.y - way.z);  // how fast it nears the ground
    const double seen = double{fog.radiance} * (1.0 - ground) + double{fog.ground} * ground;
    EXPECT_NEAR(double{tile.with.g}, meadow.exposure_gain * seen, 0.004) << tile.tile;
  }
}

// Koschmieder: with and without grass alike.
TEST(Expectation, FogDimsWhatIsSeen) {
  const test::TemporaryFolder folder("expectation_fog");
  landscape::Landscape meadow = level_meadow(folder.path());
  meadow.fog = landscape::Fog{0.3, glm::vec3(0.05F)};
  const ExpectedPicture expected = expected_picture(meadow);
  ASSERT_EQ(expected.things.size(), 1U);
  for (const ExpectedTile& tile : expected.things[0].tiles) {
    const double left = std::exp(-0.3 * 3.0 / sine_down(meadow, expected, tile.tile));
    EXPECT_NEAR(double{tile.without.g}, 4.0 * (0.02 * left + 0.05 * (1.0 - left)), 0.001);
  }
}

/// 12 x 12 cells, each of its own volume, seen from above.
void lay_all_volumes(landscape::Landscape& meadow) {
  meadow.cells.clear();
  meadow.blade_cells.clear();
  for (int i = 0; i < 144; ++i)
    meadow.cells.push_back(
        {glm::translate(glm::dmat4(1.0), {0.5 * (i / 12), 0.5 * (i % 12), 0.0}), i});
  meadow.camera = {{3.0, 2.9999, 9.0}, {3.0, 3.0, 0.0}, 60.0};
}

// More volumes than are looked at, half of them of thick grass, half of thin: each half is seen as
// it is.
TEST(Expectation, AllKindsOfGrassAreSeenHoweverManyThereAre) {
  const test::TemporaryFolder folder("expectation_kinds");
  test::ConstantMeadow shape = fog;
  shape.cells_per_side = 12;
  landscape::Landscape meadow = test::constant_meadow(shape, folder.path() / "thick");
  std::ranges::fill(meadow.terrain.values(), 0.0F);
  shape.extinction = 0.5F;
  const landscape::Landscape thin = test::constant_meadow(shape, folder.path() / "thin");
  meadow.volumes.resize(72, meadow.volumes.front());
  meadow.volumes.resize(144, thin.volumes.front());
  lay_all_volumes(meadow);
  const ExpectedPicture expected = expected_picture(meadow);
  ASSERT_EQ(expected.things.size(), 1U);
  int checked = 0;
  for (const ExpectedTile& tile : expected.things[0].tiles) {
    const int column = tile.tile % expected.tiles.x - expected.tiles.x / 2;
    if (std::abs(column) > 5 || column == 0 || column == -1) continue;
    const double ground = through(height_m, sine_down(meadow, expected, tile.tile),
                                  column < 0 ? double{fog.extinction} : 0.5);
    const double seen = double{fog.radiance} * (1.0 - ground) + double{fog.ground} * ground;
    EXPECT_NEAR(double{tile.with.g}, meadow.exposure_gain * seen, 0.01) << tile.tile;
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

// Where a few volumes speak for plants of other patches, less of them is asked for.
TEST(Expectation, AsksForLessWhereOtherPlantsSpeak) {
  const test::TemporaryFolder folder("expectation_speakers");
  test::ConstantMeadow shape = fog;
  shape.cells_per_side = 12;
  landscape::Landscape meadow = test::constant_meadow(shape, folder.path());
  std::ranges::fill(meadow.terrain.values(), 0.0F);
  meadow.volumes.resize(144, meadow.volumes.front());
  lay_all_volumes(meadow);
  const double of_one_patch = expected_picture(meadow).things.at(0).min_fraction;
  for (landscape::Cell& cell : meadow.cells) cell.origin.patch = cell.volume;
  EXPECT_EQ(of_one_patch, 0.88);
  EXPECT_EQ(expected_picture(meadow).things.at(0).min_fraction, 0.75);
}

// Of the meadow only the eastern half has cells.
TEST(Expectation, OnlyWhereCellsStandIsGrass) {
  const test::TemporaryFolder folder("expectation_half");
  landscape::Landscape meadow = level_meadow(folder.path());
  std::erase_if(meadow.cells,
                [](const landscape::Cell& cell) { return cell.world_from_cell[3].x < 1.4; });
  const ExpectedPicture expected = expected_picture(meadow);
  ASSERT_EQ(expected.things.size(), 1U);
  const int half = expected.tiles.x / 2;
  EXPECT_EQ(expected.things[0].tiles.size(), static_cast<std::size_t>(half * expected.tiles.y));
  for (const ExpectedTile& tile : expected.things[0].tiles)
    EXPECT_GE(tile.tile % expected.tiles.x, half);
}

// Looking along bare strips one sees the ground between them down to the foot, whatever stands
// beside: what a line of sight meets in one place it meets in the next.
TEST(Expectation, GapsStayOpenAllTheWayDown) {
  const test::TemporaryFolder folder("expectation_gaps");
  landscape::Landscape meadow = level_meadow(folder.path());
  test::ConstantMeadow strips = fog;
  strips.bare_voxels = strips.voxels / 2;
  meadow.volumes = test::constant_meadow(strips, folder.path() / "strips").volumes;
  meadow.camera.field_of_view_deg = 8.0;
  const ExpectedPicture expected = expected_picture(meadow);
  ASSERT_EQ(expected.things.size(), 1U);
  double left = 0.0, wanted = 0.0;
  for (const ExpectedTile& tile : expected.things[0].tiles) {
    const double seen = double{tile.with.g} / meadow.exposure_gain;
    left += (double{fog.radiance} - seen) / (double{fog.radiance} - double{fog.ground});
    wanted += 0.5 + 0.5 * through(height_m, sine_down(meadow, expected, tile.tile));
  }
  EXPECT_NEAR(left / wanted, 1.0, 0.02);
}

/// What grass south of a border lets through of the ground at a place, beyond it too.
double through_what_stands_in_front(const glm::dvec3& eye_m, const glm::dvec3& way,
                                    double border_m) {
  const double ground_m = eye_m.y - eye_m.z / way.z * way.y;
  const double enters_m = ground_m + height_m / way.z * way.y;
  if (enters_m >= border_m) return 1.0;
  const double leaves_m = std::min(ground_m, border_m);
  return std::exp(-double{fog.extinction} * (leaves_m - enters_m) / way.y);
}

// Grass hides what lies behind it, bare ground as well; cells are told apart by quarters of a
// patch.
TEST(Expectation, GrassHidesWhatIsBehind) {
  const test::TemporaryFolder folder("expectation_behind");
  landscape::Landscape meadow = level_meadow(folder.path());
  std::erase_if(meadow.cells,
                [](const landscape::Cell& cell) { return cell.world_from_cell[3].y > 1.4; });
  meadow.camera = {{1.5, -0.5, 1.0}, {1.5, 1.5, 0.0}, 30.0};
  const ExpectedPicture expected = expected_picture(meadow);
  ASSERT_EQ(expected.things.size(), 1U);
  const glm::ivec2 size_px(meadow.width_px, meadow.height_px);
  const landscape::Perspective perspective(meadow.camera, size_px);
  const glm::dvec2 tile_px = glm::dvec2(size_px) / glm::dvec2(expected.tiles);
  double hidden_beyond = 0.0;
  for (const ExpectedTile& tile : expected.things[0].tiles) {
    double ground = 0.0;
    const glm::dvec2 low_px =
        tile_px * glm::dvec2(tile.tile % expected.tiles.x, tile.tile / expected.tiles.x);
    for (int row = 0; row < 8; ++row) {
      const glm::dvec3 way =
          perspective.direction(low_px + tile_px * glm::dvec2(0.5, (row + 0.5) / 8.0));
      const double left = through_what_stands_in_front(meadow.camera.eye_m, way, 1.5);
      ground += left / 8.0;
      if (-meadow.camera.eye_m.z / way.z * way.y > 2.0) hidden_beyond += 1.0 - left;
    }
    const double seen = double{fog.radiance} * (1.0 - ground) + double{fog.ground} * ground;
    EXPECT_NEAR(double{tile.with.g}, meadow.exposure_gain * seen, 0.02) << tile.tile;
  }
  EXPECT_GT(hidden_beyond, 10.0);
}

// Half of a cell, quarter-turned: its western half lies in the south then. The camera looks
// straight down on it, north is up.
TEST(Expectation, PartsOfCellsAreWhereTheyAreTurnedTo) {
  const test::TemporaryFolder folder("expectation_part");
  landscape::Landscape meadow = level_meadow(folder.path());
  const glm::dmat4 turned({0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {1.5, 1.0, 0, 1});
  meadow.cells = {{turned, 0, glm::dmat4(1.0), {{0.0, 0.0}, {0.5, 1.0}}}};
  meadow.camera = {{1.25, 1.2499, 3.0}, {1.25, 1.25, 0.0}, 9.0};
  const ExpectedPicture expected = expected_picture(meadow);
  ASSERT_EQ(expected.things.size(), 1U);
  EXPECT_EQ(expected.things[0].tiles.size(),
            static_cast<std::size_t>(expected.tiles.x * ((expected.tiles.y + 1) / 2)));
  for (const ExpectedTile& tile : expected.things[0].tiles)
    EXPECT_GE(tile.tile / expected.tiles.x, expected.tiles.y / 2);
}

// Where the sky begins is not known, as grass rises before it: no tile with sky, none next to it.
TEST(Expectation, TilesAtTheHorizonSayNothing) {
  const test::TemporaryFolder folder("expectation_horizon");
  landscape::Landscape meadow = level_meadow(folder.path());
  meadow.camera = {{1.5, -0.5, 0.8}, {1.5, 2.9, 0.3}, 60.0};
  const ExpectedPicture expected = expected_picture(meadow);
  const landscape::Perspective perspective(meadow.camera, {meadow.width_px, meadow.height_px});
  const double edge_px = perspective.seen({1.5, 3.0, 0.0}).y;  // the ground's northern one
  const double tile_px = static_cast<double>(meadow.height_px) / expected.tiles.y;
  ASSERT_EQ(expected.things.size(), 1U);
  int uppermost = expected.tiles.y;
  for (const ExpectedTile& tile : expected.things[0].tiles)
    uppermost = std::min(uppermost, tile.tile / expected.tiles.x);
  EXPECT_GE(uppermost * tile_px, edge_px);
  EXPECT_LE(uppermost * tile_px, edge_px + 2.0 * tile_px);
}

TEST(Expectation, NothingStandsOnBareGround) {
  const test::TemporaryFolder folder("expectation_bare");
  landscape::Landscape meadow = level_meadow(folder.path());
  meadow.cells.clear();
  EXPECT_TRUE(expected_picture(meadow).things.empty());
}

TEST(Expectation, CloudsFollowBeerAndLambert) {
  const test::TemporaryFolder folder("expectation_clouds");
  landscape::Landscape sky = level_meadow(folder.path());
  test::make_cloudy_view(sky);
  const ExpectedPicture expected = expected_picture(sky);
  ASSERT_EQ(expected.things.size(), 1U);
  EXPECT_EQ(expected.things[0].name, "clouds");
  const landscape::Perspective perspective(sky.camera, {sky.width_px, sky.height_px});
  const glm::dvec2 tile_px = glm::dvec2(sky.width_px, sky.height_px) / glm::dvec2(expected.tiles);
  int inside = 0;
  for (const ExpectedTile& tile : expected.things[0].tiles) {
    const glm::dvec2 corner(tile.tile % expected.tiles.x, tile.tile / expected.tiles.x);
    constexpr int places = 16;
    double sum = 0.0;
    for (int i = 0; i < places * places; ++i) {
      const glm::dvec2 at = corner + (glm::dvec2(i % places, i / places) + 0.5) / double{places};
      sum += test::radiance_of_cloudy_view(sky, perspective.direction(at * tile_px));
    }
    // Edges within a tile are met by few rays.
    EXPECT_NEAR(double{tile.with.g}, 4.0 * sum / (places * places), 0.05) << tile.tile;
    EXPECT_TRUE(std::abs(tile.without.g - 0.24F) < 0.13F);
    inside += std::abs(double{tile.with.g} - 4.0 * sum / (places * places)) < 0.01;
  }
  EXPECT_GT(inside, 0.8 * static_cast<double>(expected.things[0].tiles.size()));
  EXPECT_GT(expected.things[0].tiles.size(), 20U);
}

// A pillar shows 4 / pi of its width on the mean (Cauchy); many hide the ground as Poisson says.
TEST(Expectation, BladesHideTheGroundByTheirWidth) {
  const test::TemporaryFolder folder("expectation_blades");
  landscape::Landscape meadow = level_meadow(folder.path());
  const glm::vec3 radiance(0.05F, 0.1F, 0.02F);
  constexpr double width_m = 0.1, tall_m = 0.3;
  meadow.blade_meshes = {test::pillar("pillar", width_m, tall_m, radiance)};
  for (const landscape::Cell& cell : meadow.cells)
    meadow.blade_cells.push_back({cell.world_from_cell, 0});
  meadow.cells.clear();
  const ExpectedPicture expected = expected_picture(meadow);
  ASSERT_EQ(expected.things.size(), 1U);
  EXPECT_EQ(expected.things[0].name, "blades");
  for (const ExpectedTile& tile : expected.things[0].tiles) {
    const double sine = sine_down(meadow, expected, tile.tile);
    const double depth = 4.0 / std::numbers::pi * width_m * tall_m * std::sqrt(1.0 - sine * sine) /
                         (sine * 0.5 * 0.5);
    const double seen = 0.1 * -std::expm1(-depth) + double{fog.ground} * std::exp(-depth);
    EXPECT_NEAR(double{tile.with.g}, 4.0 * seen, 0.01) << tile.tile;
  }
}

// Where two opposite heights of a square of samples are 8 m higher, the mesh of renderers lies 4 m
// off the bilinear ground in its middle.
TEST(GroundMarch, MeetsTheMesh) {
  constexpr double step_m = 30.0;
  Heightfield terrain(2, step_m);
  terrain.at(1, 0) = terrain.at(0, 1) = 8.0F;
  const glm::dvec3 eye_m(0.5 * step_m, 0.5 * step_m, 100.0);
  EXPECT_NEAR(GroundMarch(terrain).distance_m(eye_m, {0.0, 0.0, -1.0}), 100.0, 0.05);
}

}  // namespace
}  // namespace wold::expectation
