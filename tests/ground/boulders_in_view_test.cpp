#include "ground/boulders_in_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/mesh_height.h"
#include "place/site.h"
#include "place/view.h"

namespace wold::ground {
namespace {

/// A meadow of 60 m with many boulders, from 3 m above its southern edge.
scene::Scene with_boulders() {
  scene::Scene scene;
  scene.terrain.size_m = 60.0;
  scene.terrain.samples = 121;
  scene.terrain.boulders_per_hectare = 200.0;
  scene.camera.eye_m = {30.0, 1.0};
  scene.camera.eye_height_m = 3.0;
  scene.camera.target_m = {30.0, 30.0};
  scene.camera.target_height_m = 0.0;
  scene.ageing.frames = {0.3};
  return scene;
}

/// With coarse maps: boulders are not made of them.
place::Site site_of(const scene::Scene& scene) {
  return place::make_site(
      scene, nullptr, {},
      place::Sketch{
          .ground_samples = 65, .light_samples = 33, .lean_light_samples = 33, .snow_samples = 33});
}

landscape::Landscape landscape_of(const scene::Scene& scene, const place::Site& site,
                                  int width_px) {
  landscape::Landscape landscape;
  landscape.terrain = site.terrain;
  landscape.camera = place::camera_of_frame(scene, site.terrain, 1);
  landscape.width_px = width_px;
  landscape.height_px = width_px * 9 / 16;
  return landscape;
}

double area_m2(const landscape::RaisedGround& raised, std::size_t triangle) {
  const glm::uvec3& corners = raised.triangles[triangle];
  const glm::dvec2 a(raised.points_m[corners.x]), b(raised.points_m[corners.y]),
      c(raised.points_m[corners.z]);
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

void expect_on_the_ground(int terrain_samples) {
  scene::Scene scene = with_boulders();
  scene.terrain.samples = terrain_samples;
  const place::Site site = site_of(scene);
  const landscape::RaisedGround raised = boulders_in_view(site, landscape_of(scene, site, 960));
  const terrain::NearbyBoulders nearby = site.boulders->nearby(site.terrain.square(), 0.0);
  ASSERT_GT(raised.points_m.size(), 500U);
  std::size_t high = 0;
  for (const glm::vec3& from_origin_m : raised.points_m) {
    const glm::dvec3 at_m = raised.origin_m + glm::dvec3(from_origin_m);
    const double over_ground_m = at_m.z - double{mesh_height_m(site.terrain, glm::dvec2(at_m))};
    const double height_m = nearby.at(glm::dvec2(at_m)).height_m;
    EXPECT_LT(over_ground_m, height_m + 1e-3);
    EXPECT_GT(over_ground_m, -0.3);
    high += over_ground_m > 0.1;
  }
  EXPECT_GT(high, raised.points_m.size() / 3);
}

TEST(BouldersInView, StandOnTheGroundAsHighAsTheyAre) {
  expect_on_the_ground(121);
  expect_on_the_ground(17);  // whose triangles and bilinear heights differ
}

// Without snow there is none to hide them: by 3.75 m steps as many are seen as by steps of half a
// metre.
TEST(BouldersInView, AreAsManyOnCoarseHeights) {
  const auto triangles = [](int samples) {
    scene::Scene scene = with_boulders();
    scene.terrain.samples = samples;
    const place::Site site = site_of(scene);
    return static_cast<double>(
        boulders_in_view(site, landscape_of(scene, site, 960)).triangles.size());
  };
  EXPECT_NEAR(triangles(17), triangles(121), 0.15 * triangles(121));
}

TEST(BouldersInView, AreSeenFromAboveOnceAndWithoutGaps) {
  const scene::Scene scene = with_boulders();
  const place::Site site = site_of(scene);
  const landscape::RaisedGround raised = boulders_in_view(site, landscape_of(scene, site, 960));
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  double all_m2 = 0.0;
  for (std::size_t k = 0; k < raised.triangles.size(); ++k) {
    EXPECT_GT(area_m2(raised, k), -1e-6);
    all_m2 += area_m2(raised, k);
    for (int corner = 0; corner < 3; ++corner)
      EXPECT_TRUE(
          edges.emplace(raised.triangles[k][corner], raised.triangles[k][(corner + 1) % 3]).second);
  }
  // Of each edge the other side is a triangle, too, but at the rings in the ground.
  std::size_t alone = 0;
  for (const auto& [from, to] : edges) alone += !edges.contains({to, from});
  EXPECT_LT(alone, edges.size() / 6);
  EXPECT_GT(all_m2, 3.0);
}

TEST(BouldersInView, AreFinerTheLargerThePicture) {
  const scene::Scene scene = with_boulders();
  const place::Site site = site_of(scene);
  std::size_t before = 0;
  for (const int width_px : {48, 192, 768}) {
    const std::size_t now =
        boulders_in_view(site, landscape_of(scene, site, width_px)).triangles.size();
    EXPECT_GT(now, 3 * before / 2) << width_px;
    before = now;
  }
}

TEST(BouldersInView, AreNotDrawnBehindTheCameraNorUnderSnow) {
  const scene::Scene scene = with_boulders();
  const place::Site site = site_of(scene);
  landscape::Landscape landscape = landscape_of(scene, site, 960);
  landscape.camera.eye_m.y = 25.0;
  const landscape::RaisedGround raised = boulders_in_view(site, landscape);
  EXPECT_FALSE(raised.triangles.empty());
  for (const glm::vec3& from_origin_m : raised.points_m)
    EXPECT_GT(raised.origin_m.y + double{from_origin_m.y}, 25.0 - 5.0);
  std::ranges::for_each(landscape.terrain.values(), [](float& height_m) { height_m += 4.0F; });
  landscape.camera.eye_m.z += 4.0;
  landscape.camera.target_m.z += 4.0;
  EXPECT_TRUE(boulders_in_view(site, landscape).triangles.empty());
}

TEST(BouldersInView, LowOnesAreNotDrawnUnderSomeSnow) {
  constexpr float snow_m = 0.6F;
  const scene::Scene scene = with_boulders();
  const place::Site site = site_of(scene);
  landscape::Landscape landscape = landscape_of(scene, site, 960);
  std::ranges::for_each(landscape.terrain.values(), [](float& height_m) { height_m += snow_m; });
  landscape.camera.eye_m.z += 2.0;
  const landscape::RaisedGround raised = boulders_in_view(site, landscape);
  EXPECT_FALSE(raised.triangles.empty());
  const terrain::NearbyBoulders nearby = site.boulders->nearby(site.terrain.square(), 0.0);
  for (const terrain::Boulder& boulder : nearby.all()) {
    if (terrain::Boulder::most_height_m(boulder.width_m()) > double{snow_m}) continue;
    for (const glm::vec3& from_origin_m : raised.points_m)
      EXPECT_GT(glm::distance(glm::dvec2(raised.origin_m) + glm::dvec2(from_origin_m),
                              boulder.middle_m()),
                1e-3);
  }
}

TEST(BouldersInView, LeaveTheEyeItsPlace) {
  const scene::Scene scene = with_boulders();
  const place::Site site = site_of(scene);
  landscape::Landscape landscape = landscape_of(scene, site, 960);
  const terrain::NearbyBoulders nearby = site.boulders->nearby(site.terrain.square(), 0.0);
  const auto widest = std::ranges::max_element(nearby.all(), {}, &terrain::Boulder::width_m);
  landscape.camera.eye_m =
      place::above_ground(site.terrain, widest->middle_m() + glm::dvec2(0.1, 0.0), 0.5);
  landscape.camera.target_m = landscape.camera.eye_m + glm::dvec3(0.0, 10.0, 0.0);
  const landscape::RaisedGround raised = boulders_in_view(site, landscape);
  for (const glm::vec3& from_origin_m : raised.points_m) {
    const glm::dvec3 at_m = raised.origin_m + glm::dvec3(from_origin_m);
    EXPECT_GT(glm::distance(glm::dvec2(at_m), widest->middle_m()), 0.3 * widest->width_m());
  }
}

}  // namespace
}  // namespace wold::ground
