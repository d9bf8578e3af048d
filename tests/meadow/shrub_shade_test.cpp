#include "meadow/shrub_shade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "grass/geometry/crown.h"
#include "landscape/cell_parts.h"
#include "scene/species.h"

namespace wold::meadow {
namespace {

constexpr double terrain_m = 12.0;

scene::Scene with_shrubs() {
  scene::Scene scene;
  scene.terrain.size_m = terrain_m;
  scene.species.resize(2);
  scene.species[0].plant.height_m = 0.1;
  scene::Plant& shrub = scene.species[1].plant;
  shrub.crown_m = 0.4;
  shrub.height_m = 0.05;
  scene.species[1].habitat.cover = 0.1;
  return scene;
}

/// Shrubs about the terrain's middle, as large as `size` says.
CellChoice shrubs(const scene::Scene& scene, const Heightfield& terrain, double size) {
  CellChoice choice;
  choice.cell = glm::ivec2(0.5 * terrain_m / scene.grass.patch_m);
  const landscape::CellPose pose{choice.cell, 1, glm::dvec2(0.0), {0.1, -0.2}, size};
  choice.beside_cell = {
      landscape::fit_to_ground(terrain, scene.grass.patch_m, pose, {}).world_from_cell, 1.0};
  return choice;
}

glm::dvec3 sun_at(double elevation_deg) {
  const double elevation = elevation_deg * std::numbers::pi / 180.0;
  return {std::cos(elevation) * 0.6, -std::cos(elevation) * 0.8, std::sin(elevation)};
}

/// A ridge from south to north, or a slope where it is not bent.
Heightfield ridge(double rise, double bend_per_m) {
  Heightfield terrain(97, terrain_m);
  for (int j = 0; j < 97; ++j)
    for (int i = 0; i < 97; ++i) {
      const double from_middle_m = terrain.place_m(i, j).x - 0.5 * terrain_m;
      terrain.at(i, j) = static_cast<float>(from_middle_m * (rise - bend_per_m * from_middle_m));
    }
  return terrain;
}

/// How far a ray goes on within cushions, step by step; 0 from below one.
double marched_m(const std::vector<grass::Crown::Cushion>& cushions,
                 const glm::dmat4& cell_from_world, const glm::dvec3& start_m,
                 const glm::dvec3& to_sun) {
  constexpr double step_m = 1e-3, far_m = 2.0;
  double way_m = 0.0;
  const auto within = [](const grass::Crown::Cushion& cushion, const glm::dvec3& at_m) {
    const glm::dvec2 level = (glm::dvec2(at_m) - cushion.middle_m) / cushion.radius_m;
    return glm::dot(level, level) + at_m.z * at_m.z / (cushion.height_m * cushion.height_m) < 1.0;
  };
  const glm::dvec3 first_m(cell_from_world * glm::dvec4(start_m, 1.0));
  for (const grass::Crown::Cushion& cushion : cushions) {
    if (within(cushion, {glm::dvec2(first_m), 0.0})) return 0.0;
    for (double m = 0.5 * step_m; m < far_m; m += step_m) {
      const glm::dvec3 at_m(cell_from_world * glm::dvec4(start_m + m * to_sun, 1.0));
      if (at_m.z > 0.0 && within(cushion, at_m)) way_m += step_m;
    }
  }
  return way_m;
}

// Against steps through the crowns, on level ground, on a slope and on a ridge, beside which one is
// lower than the shrubs' foot, for shrubs of two sizes: their leaves are spread over what the
// crowns hold.
TEST(ShrubShade, IsAsDeepAsTheWayThroughCrowns) {
  const scene::Scene scene = with_shrubs();
  const grass::Crown crown =
      grass::crown_of(scene.species[1].plant, scene.grass.patch_m, scene.seed, 0);
  double volume_m3 = 0.0;
  for (const grass::Crown::Cushion& cushion : crown.cushions())
    volume_m3 +=
        2.0 / 3.0 * std::numbers::pi * cushion.radius_m * cushion.radius_m * cushion.height_m;
  const double leaves_m2 = scene::blades_of(scene).back() * scene::blade_area_m2(scene.species[1]);
  const double extinction_per_m = 0.5 * leaves_m2 / volume_m3;
  const double eye_m = 0.5 * scene::mean_grass(scene).height_m;
  for (const Heightfield& terrain : {ridge(0.0, 0.0), ridge(0.4, 0.0), ridge(0.0, 0.3)})
    for (const double size : {0.8, 1.2}) {
      const std::vector<CellChoice> choices = {shrubs(scene, terrain, size)};
      const glm::dvec3 to_sun = sun_at(25.0);
      const std::optional<FactorMap> sunlit =
          ShrubShade(scene, choices, to_sun).sunlit(terrain, {{.size_m = terrain_m}, 301});
      ASSERT_TRUE(sunlit);
      const glm::dmat4 cell_from_world =
          glm::inverse(choices.front().beside_cell->world_from_patch);
      int shaded = 0;
      for (int j = 105; j < 240; ++j)
        for (int i = 90; i < 195; ++i) {
          const glm::dvec2 at_m = sunlit->place_m(i, j);
          const glm::dvec3 start_m(at_m, double{terrain.sample(at_m.x, at_m.y)} + eye_m);
          const double way_m = marched_m(crown.cushions(), cell_from_world, start_m, to_sun);
          const double want = std::exp(-extinction_per_m * way_m);
          EXPECT_NEAR(sunlit->at(i, j), want, 0.02);
          shaded += want < 0.98;
        }
      EXPECT_GT(shaded, 30);
      EXPECT_NEAR(std::ranges::count_if(sunlit->values(), [](float f) { return f < 0.98F; }),
                  shaded, 4);
    }
}

TEST(ShrubShade, IsThatOfWhatIsShownOfThem) {
  const scene::Scene scene = with_shrubs();
  const Heightfield level = ridge(0.0, 0.0);
  const GroundGrid grid{{.size_m = terrain_m}, 201};
  const auto darkest = [&](double standing, double elevation_deg) {
    CellChoice choice = shrubs(scene, level, 1.0);
    choice.beside_cell->standing = standing;
    const auto sunlit =
        ShrubShade(scene, std::vector{choice}, sun_at(elevation_deg)).sunlit(level, grid);
    return sunlit ? std::ranges::min(sunlit->values()) : 1.0F;
  };
  EXPECT_NEAR(std::log(darkest(0.5, 25.0)) / std::log(darkest(1.0, 25.0)), 0.5, 1e-4);
  EXPECT_EQ(darkest(0.0, 25.0), 1.0F);
  EXPECT_GT(darkest(1.0, 2.5), 0.95F);  // at sunset it fades
}

TEST(ShrubShade, IsFineInSmallShrubs) {
  const scene::Scene scene = with_shrubs();
  const Heightfield level = ridge(0.0, 0.0);
  const double step_m = 1.2 * scene.grass.patch_m;
  const GroundGrid coarse{{.size_m = 10.0 * step_m}, 11};
  const auto is_shown = [&](double size) {
    return ShrubShade(scene, std::vector{shrubs(scene, level, size)}, sun_at(20.0))
        .sunlit(level, coarse)
        .has_value();
  };
  EXPECT_TRUE(is_shown(1.0));
  EXPECT_FALSE(is_shown(0.5));
}

// Snow that buries shrubs takes their shade with them.
TEST(ShrubShade, FallsOnTheSnowThatLiesAroundThem) {
  const scene::Scene scene = with_shrubs();
  const Heightfield level = ridge(0.0, 0.0);
  const ShrubShade shade(scene, std::vector{shrubs(scene, level, 1.0)}, sun_at(25.0));
  const auto shaded = [&](double depth_m) {
    const auto sunlit = shade.sunlit(level, {{.size_m = terrain_m}, 201},
                                     [&](const glm::dvec2&) { return depth_m; });
    return std::ranges::count_if(sunlit->values(), [](float f) { return f < 0.98F; });
  };
  const auto half_grass_m = 0.5 * scene::mean_grass(scene).height_m;
  EXPECT_GT(shaded(0.0), 30);
  EXPECT_EQ(shaded(half_grass_m), shaded(0.0));
  EXPECT_LT(shaded(0.5 * scene.species[1].plant.crown_m), 0.8 * shaded(0.0));
  EXPECT_EQ(shaded(scene.species[1].plant.crown_m), 0);
}

TEST(ShrubShade, IsNoneOfWhatStandsOnItsCellOrWithoutASun) {
  const scene::Scene scene = with_shrubs();
  const Heightfield level = ridge(0.0, 0.0);
  CellChoice choice = shrubs(scene, level, 1.0);
  const GroundGrid grid{{.size_m = terrain_m}, 201}, coarse{{.size_m = terrain_m}, 9};
  EXPECT_TRUE(ShrubShade(scene, std::vector{choice}, sun_at(20.0)).sunlit(level, grid));
  EXPECT_FALSE(ShrubShade(scene, std::vector{choice}, sun_at(20.0)).sunlit(level, coarse));
  EXPECT_FALSE(ShrubShade(scene, std::vector{choice}, sun_at(-1.0)).sunlit(level, grid));
  choice.beside_cell.reset();
  EXPECT_FALSE(ShrubShade(scene, std::vector{choice}, sun_at(20.0)).sunlit(level, grid));
}

}  // namespace
}  // namespace wold::meadow
