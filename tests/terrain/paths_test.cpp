#include "terrain/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include "core/row_parts.h"
#include "terrain/boulders.h"
#include "terrain/ground.h"
#include "terrain/lighting.h"
#include "terrain/relief.h"
#include "terrain/surface.h"
#include "terrain/walked_way.h"

namespace wold::terrain {
namespace {

constexpr double degrees = 180.0 / 3.14159265358979;

/// Heights by `height_m(place)` on a square.
template <class Height>
Heightfield heights(double size_m, const Height& height_m) {
  Heightfield map(201, size_m);
  for (int j = 0; j < map.samples(); ++j)
    for (int i = 0; i < map.samples(); ++i)
      map.at(i, j) = static_cast<float>(height_m(map.place_m(i, j)));
  return map;
}

Heightfield level_ground() {
  return heights(100.0, [](const glm::dvec2&) { return 0.0; });
}

double length_m(const std::vector<glm::dvec2>& line) {
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) sum += glm::distance(line[k], line[k + 1]);
  return sum;
}

double highest_m(const Heightfield& ground, const std::vector<glm::dvec2>& line) {
  double highest = -1e9;
  for (const glm::dvec2& at_m : line)
    highest = std::max(highest, double{ground.sample(at_m.x, at_m.y)});
  return highest;
}

// 5 km/h on level ground [Tobler1993].
TEST(WalkedWay, TakesAsLongAsToblerSays) {
  EXPECT_NEAR(3.6 / seconds_per_metre(0.0), 5.04, 0.01);
  // Up 20 degrees 1.4 km/h, down them 2.0.
  EXPECT_NEAR(3.6 / seconds_per_metre(std::tan(20.0 / degrees)), 2.0 / (1.0 / 1.41 + 1.0 / 2.0),
              0.02);
  EXPECT_EQ(seconds_per_metre(0.2), seconds_per_metre(-0.2));
}

TEST(WalkedWay, IsStraightOnLevelGround) {
  for (const glm::dvec2& to_m : {glm::dvec2(90.0, 50.0), glm::dvec2(70.0, 91.0)}) {
    const glm::dvec2 from_m(10.0, 20.0), along = glm::normalize(to_m - from_m);
    const std::vector<glm::dvec2> way = walked_way(level_ground(), from_m, to_m, nullptr);
    EXPECT_EQ(way.front(), from_m);
    EXPECT_EQ(way.back(), to_m);
    for (const glm::dvec2& at_m : way)
      EXPECT_NEAR(along.x * (at_m - from_m).y - along.y * (at_m - from_m).x, 0.0, 1e-6);
    EXPECT_NEAR(length_m(way), glm::distance(from_m, to_m), 1e-6) << "there and back nowhere";
  }
}

TEST(WalkedWay, GoesRoundAHill) {
  const Heightfield hill = heights(400.0, [](const glm::dvec2& at_m) {
    return 60.0 * std::exp(-glm::dot(at_m - 200.0, at_m - 200.0) / (2.0 * 40.0 * 40.0));
  });
  const std::vector<glm::dvec2> way = walked_way(hill, {60.0, 195.0}, {340.0, 205.0}, nullptr);
  EXPECT_LT(highest_m(hill, way), 25.0);
  EXPECT_LT(length_m(way), 1.5 * 280.0);
}

// Tobler's function climbs fastest on a slope of 1 / 3.5: what is steeper takes longer straight up
// than in bends.
TEST(WalkedWay, ClimbsSteepSlopesInAFewBends) {
  const Heightfield slope = heights(200.0, [](const glm::dvec2& at_m) { return 0.6 * at_m.y; });
  const std::vector<glm::dvec2> way = walked_way(slope, {100.0, 40.0}, {100.0, 160.0}, nullptr);
  EXPECT_NEAR(72.0 / length_m(way), 1.0 / 3.5, 0.06);
  int bends = 0;
  double side = 0.0;
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    const double east = way[k + 1].x - way[k].x;
    if (east * side < 0.0) ++bends;
    if (east != 0.0) side = east;
  }
  EXPECT_GE(bends, 1);
  EXPECT_LE(bends, 12);
}

// A lake 40 m wide lies on the straight way.
TEST(WalkedWay, GoesRoundLakes) {
  GroundMap<int> number(201, 100.0, -1);
  for (int j = 0; j < number.samples(); ++j)
    for (int i = 0; i < number.samples(); ++i)
      if (glm::distance(number.place_m(i, j), glm::dvec2(50.0)) < 20.0) number.at(i, j) = 0;
  const Water lake({number, {1.0}}, 1);
  const std::vector<glm::dvec2> way = walked_way(level_ground(), {10.0, 50.0}, {90.0, 50.0}, &lake);
  for (const glm::dvec2& at_m : way) EXPECT_GT(glm::distance(at_m, glm::dvec2(50.0)), 18.0);
  EXPECT_LT(length_m(way), 100.0);
}

scene::Path straight(double width_m = 0.8) { return {{10.0, 50.0, 90.0, 50.0}, width_m}; }

/// North of the middle of the first path at an east of its.
double middle_at(const Paths& paths, double east_m) {
  const std::vector<glm::dvec2> line = paths.lines_m().front();
  const auto beyond =
      std::ranges::find_if(line, [&](const glm::dvec2& at_m) { return at_m.x >= east_m; });
  const glm::dvec2 &a = *(beyond - 1), &b = *beyond;
  return std::lerp(a.y, b.y, (east_m - a.x) / (b.x - a.x));
}

TEST(Paths, AreBareInTheMiddleAndLeaveTheMeadowBesideThem) {
  const Heightfield ground = level_ground();
  const Paths paths(ground, {straight()}, 1, nullptr);
  const GroundGrid grid{{{40.0, 45.0}, 10.0}, 501};
  const TroddenPlaces places = paths.on_grid(ground, grid, whole_rows(grid.samples));
  const auto bare_at = [&](const glm::dvec2& at_m) {
    const glm::ivec2 value(glm::round((at_m - grid.square.corner_m) / grid.step_m()));
    return places.at(value.x, value.y).bare;
  };
  for (double east_m = 41.0; east_m < 49.0; east_m += 0.5) {
    const double middle_m = middle_at(paths, east_m);
    EXPECT_NEAR(middle_m, 50.0, 2.0);  // it wanders, but not far
    EXPECT_GE(bare_at({east_m, middle_m}), 0.6);
    EXPECT_LE(bare_at({east_m, middle_m + 0.7}), 0.3);
    EXPECT_GT(bare_at({east_m, middle_m + 0.7}), 0.0) << "trampled";
    EXPECT_EQ(bare_at({east_m, middle_m - 1.8}), 0.0);
  }
}

// A map shows as much bare ground, however coarse it is.
TEST(Paths, CoverAsMuchOnAnyMap) {
  const Heightfield ground = level_ground();
  const Paths paths(ground, {straight()}, 1, nullptr);
  const auto bare_m2 = [&](int samples) {
    const GroundGrid grid{{{20.0, 30.0}, 40.0}, samples};
    const TroddenPlaces places = paths.on_grid(ground, grid, whole_rows(grid.samples));
    double sum = 0.0;
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i) sum += places.at(i, j).bare;
    return sum * grid.step_m() * grid.step_m();
  };
  const double fine_m2 = bare_m2(801);
  EXPECT_NEAR(fine_m2 / (40.0 * 0.8), 1.25, 0.15);  // with what is trampled beside it
  for (const int samples : {201, 81, 41, 21})
    EXPECT_NEAR(bare_m2(samples) / fine_m2, 1.0, 0.2) << samples;
  // A path of 0.8 m covers two fifths of a square of 2 m, wherever its sample lies.
  const GroundGrid coarse{{{20.0, 30.0}, 40.0}, 21};
  const TroddenPlaces places = paths.on_grid(ground, coarse, whole_rows(coarse.samples));
  for (int j = 0; j < coarse.samples; ++j)
    for (int i = 0; i < coarse.samples; ++i) EXPECT_LE(places.at(i, j).bare, 0.41);
}

// The tread is level across a slope, and the bank above it steeper than that.
TEST(Paths, AreLevelAcrossTheSlope) {
  const Heightfield slope = heights(100.0, [](const glm::dvec2& at_m) { return 0.3 * at_m.y; });
  const Paths paths(slope, {straight(1.2)}, 1, nullptr);
  const GroundGrid grid{{{45.0, 45.0}, 10.0}, 1001};
  const Surface surface(slope, nullptr, grid, {.paths = &paths});
  const auto slope_deg = [&](double from_middle_m) {
    double sum = 0.0;
    int count = 0;
    for (double east_m = 46.0; east_m < 54.0; east_m += 0.1, ++count) {
      const glm::dvec2 at_m(east_m, middle_at(paths, east_m) + from_middle_m);
      const glm::ivec2 value(glm::round((at_m - grid.square.corner_m) / grid.step_m()));
      sum += surface.slope_deg(value.x, value.y);
    }
    return sum / count;
  };
  EXPECT_LT(slope_deg(0.1), 8.0);
  EXPECT_GT(slope_deg(0.85), 20.0);
  EXPECT_NEAR(slope_deg(3.0), std::atan(0.3) * degrees, 0.1);
}

TEST(Paths, AreEvenedOutBySnow) {
  const Heightfield slope = heights(100.0, [](const glm::dvec2& at_m) { return 0.3 * at_m.y; });
  const Paths paths(slope, {straight(1.2)}, 1, nullptr);
  const GroundGrid grid{{{45.0, 45.0}, 10.0}, 501};
  const Surface surface(slope, nullptr, grid, {.paths = &paths}, {},
                        {[](const glm::dvec2&) { return 0.5; }, {}});
  for (int j = 0; j < grid.samples; ++j)
    EXPECT_NEAR(surface.slope_deg(250, j), std::atan(0.3) * degrees, 0.01);
}

TEST(Paths, HaveNoBoulders) {
  const Heightfield ground = level_ground();
  scene::Terrain terrain;
  terrain.size_m = ground.size_m();
  terrain.boulders_per_hectare = 200.0;
  const auto paths = std::make_shared<const Paths>(
      ground, std::vector<scene::Path>{straight(), {{50.0, 5.0, 50.0, 95.0}, 1.5}}, 1, nullptr);
  const auto on_paths = [&](const std::shared_ptr<const Paths>& cleared) {
    const Boulders boulders(ground, terrain, 1, nullptr, nullptr, cleared);
    const NearbyBoulders nearby = boulders.nearby(ground.square(), 0.0);
    return std::ranges::count_if(nearby.all(), [&](const Boulder& boulder) {
      return paths->lead_past(boulder.middle_m(), 0.2);
    });
  };
  EXPECT_GT(on_paths(nullptr), 0);
  EXPECT_EQ(on_paths(paths), 0);
}

// A narrow path leaves no grass in the wide one that it crosses.
TEST(Paths, CrossEachOther) {
  const Heightfield ground = level_ground();
  const scene::Path wide = straight(4.0), narrow{{50.0, 10.0, 50.0, 90.0}, 0.5};
  const GroundGrid grid{{{45.0, 45.0}, 10.0}, 101};
  const auto places_of = [&](const std::vector<scene::Path>& paths) {
    return Paths(ground, paths, 1, nullptr).on_grid(ground, grid, whole_rows(grid.samples));
  };
  const TroddenPlaces alone = places_of({wide}), both = places_of({wide, narrow}),
                      other_order = places_of({narrow, wide});
  for (int j = 0; j < grid.samples; ++j)
    for (int i = 0; i < grid.samples; ++i) {
      EXPECT_GE(both.at(i, j).bare, alone.at(i, j).bare);
      EXPECT_EQ(both.at(i, j).bare, other_order.at(i, j).bare);
    }
}

// A map is made where it counts alone.
TEST(Paths, AreWhereTheMapCounts) {
  const Heightfield ground = level_ground();
  const Paths paths(ground, {straight()}, 1, nullptr);
  const GroundGrid grid{{{40.0, 40.0}, 20.0}, 101};
  const TroddenPlaces all = paths.on_grid(ground, grid, whole_rows(grid.samples));
  const RowParts parts(static_cast<std::size_t>(grid.samples), RowPart{{30, 60}});
  const TroddenPlaces some = paths.on_grid(ground, grid, parts);
  for (int j = 0; j < grid.samples; ++j)
    for (int i = 0; i < grid.samples; ++i)
      EXPECT_EQ(some.at(i, j).bare, i >= 30 && i < 60 ? all.at(i, j).bare : 0.0);
  EXPECT_FALSE(some.empty());
  EXPECT_TRUE(paths.on_grid(ground, {{{0.0, 80.0}, 20.0}, 101}, whole_rows(101)).empty());
}

TEST(Paths, LeaveWaterLevel) {
  const Heightfield slope = heights(100.0, [](const glm::dvec2& at_m) { return 0.3 * at_m.y; });
  const Paths paths(slope, {straight(1.2)}, 1, nullptr);
  const Water lake({GroundMap<int>(51, 100.0, 0), {1.0}}, 1);
  const GroundGrid grid{{{45.0, 45.0}, 10.0}, 101};
  const Surface surface(slope, nullptr, grid, {.water = &lake, .paths = &paths});
  for (int j = 0; j < grid.samples; ++j)
    EXPECT_NEAR(surface.slope_deg(50, j), std::atan(0.3) * degrees, 0.01);
}

// Their soil is paler, and they are of the ground that a scene's is made to be.
TEST(Paths, ArePaleSoilOfTheGround) {
  scene::Terrain look;
  look.hill_height_m = 0.0;
  look.relief_m = 0.0;
  const auto reflectance = [&](const std::vector<scene::Path>& paths) {
    const Ground ground = make_ground(look, 1, {}, paths);
    const GroundGrid grid{{{10.0, 10.0}, 20.0}, 201};
    const Surface surface(ground.heights_m, nullptr, grid, ground.known());
    return ground_reflectance(surface, {0.0, 0.6, 0.8}, look, 1,
                              FactorMap(grid.samples, grid.square, 0.0F));
  };
  const ColourMap plain = reflectance({}), trodden = reflectance({{{5, 20, 35, 20}, 2.0}});
  EXPECT_NEAR(double{trodden.sample(20.0, 20.0).g / plain.sample(20.0, 20.0).g}, 1.3, 0.06);
  EXPECT_EQ(trodden.sample(20.0, 29.0), plain.sample(20.0, 29.0));
}

TEST(Paths, WithoutPlacesAreNone) {
  const Heightfield ground = level_ground();
  const Paths paths(ground, {{}}, 1, nullptr);
  EXPECT_TRUE(paths.lines_m().empty());
  EXPECT_FALSE(paths.lead_past({50.0, 50.0}, 4.0));
}

}  // namespace
}  // namespace wold::terrain
