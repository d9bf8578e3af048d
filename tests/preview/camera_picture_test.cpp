#include "preview/camera_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/colour.h"
#include "landscape/perspective.h"
#include "preview/flakes.h"
#include "preview/ground_and_sky.h"
#include "preview/tubes.h"

namespace wold::test {
namespace {

using landscape::Perspective;
using preview::Canvas;

constexpr int side_px = 64;

/// A level field of 100 m at height 0 under a sky of one colour, seen from 2 m.
landscape::Landscape level_field() {
  landscape::Landscape field;
  field.terrain = Heightfield(11, 100.0);
  field.ground = ColourMap(11, 100.0, {0.25F, 0.5F, 0.125F});
  field.light = ColourMap(2, 100.0, glm::vec3(1.0F));
  field.sky = Image(8, 4, 3);
  std::fill(field.sky.values.begin(), field.sky.values.end(), 0.75F);
  field.camera = {{50.0, 1.0, 2.0}, {50.0, 11.0, 0.0}, 60.0};
  field.width_px = field.height_px = side_px;
  return field;
}

Perspective perspective_of(const landscape::Landscape& field) {
  return {field.camera, {side_px, side_px}};
}

TEST(Perspective, SeesInAPixelWhatLiesInItsDirection) {
  const Perspective perspective = perspective_of(level_field());
  for (const glm::dvec2 at_px : {glm::dvec2(3.0, 60.0), {32.0, 32.0}, {50.5, 7.25}}) {
    const glm::dvec3 direction = perspective.direction(at_px);
    const glm::dvec3 seen = perspective.seen(perspective.eye_m() + 7.0 * direction);
    EXPECT_NEAR(seen.x, at_px.x, 1e-9);
    EXPECT_NEAR(seen.y, at_px.y, 1e-9);
    EXPECT_NEAR(seen.z, 7.0 * perspective.depth_along(direction), 1e-9);
  }
  // 60 degrees across, and up is up.
  EXPECT_NEAR(glm::dot(perspective.direction({0, 32}), perspective.direction({64, 32})), 0.5, 1e-9);
  EXPECT_GT(perspective.direction({32, 0}).z, perspective.direction({32, 64}).z);
}

Canvas painted(const landscape::Landscape& field, const Perspective& perspective) {
  Canvas canvas(side_px, side_px);
  paint_ground_and_sky(field, perspective, canvas);
  return canvas;
}

TEST(GroundAndSky, RaysMeetALevelFieldWhereTheyShould) {
  const landscape::Landscape field = level_field();
  const Perspective perspective = perspective_of(field);
  Canvas canvas = painted(field, perspective);
  int ground = 0;
  for (int y = 0; y < side_px; ++y)
    for (int x = 0; x < side_px; ++x) {
      const glm::dvec3 direction = perspective.direction({x + 0.5, y + 0.5});
      const double distance_m = -2.0 / direction.z;
      const glm::dvec3 place = field.camera.eye_m + distance_m * direction;
      const bool hits = direction.z < 0.0 && std::max(std::abs(place.x - 50.0), place.y) < 49.9;
      if (!hits && direction.z < 0.0) continue;  // near the terrain's edge
      EXPECT_FLOAT_EQ(canvas.radiance.pixel(x, y)[1], hits ? 0.5F : 0.75F) << x << ", " << y;
      if (!hits) continue;
      ++ground;
      EXPECT_NEAR(canvas.depth_at(x, y), distance_m * perspective.depth_along(direction),
                  1e-3 * distance_m);
    }
  EXPECT_GT(ground, side_px * side_px / 3);
}

TEST(GroundAndSky, RaysEndOnUnevenGround) {
  landscape::Landscape field = level_field();
  field.terrain = Heightfield(51, 100.0);
  for (int j = 0; j < 51; ++j)
    for (int i = 0; i < 51; ++i)
      field.terrain.at(i, j) = static_cast<float>(std::sin(0.8 * i) + std::cos(0.5 * j) - 2.0);
  const Perspective perspective = perspective_of(field);
  Canvas canvas = painted(field, perspective);
  int ground = 0;
  for (int y = 0; y < side_px; ++y)
    for (int x = 0; x < side_px; ++x) {
      if (!std::isfinite(canvas.depth_at(x, y))) continue;
      const glm::dvec3 direction = perspective.direction({x + 0.5, y + 0.5});
      const double distance_m = canvas.depth_at(x, y) / perspective.depth_along(direction);
      const glm::dvec3 place = field.camera.eye_m + distance_m * direction;
      ++ground;
      EXPECT_NEAR(place.z, field.terrain.sample(place.x, place.y), 0.01 * distance_m)
          << x << ", " << y;
    }
  EXPECT_GT(ground, side_px * side_px / 3);
}

TEST(GroundAndSky, FinerPicturesAreSeenInsideTheirSquares) {
  landscape::Landscape field = level_field();
  field.ground_details = {{ColourMap(11, 30.0, {0.0F, 0.0F, 1.0F}), {35.0, 0.0}}};
  const Perspective perspective = perspective_of(field);
  Canvas canvas(side_px, side_px);
  paint_ground_and_sky(field, perspective, canvas);
  const double soft_m = landscape::soft_border_m(field.ground, field.ground_details[0]);
  int inside = 0, outside = 0;
  for (int y = 0; y < side_px; ++y) {
    const glm::dvec3 direction = perspective.direction({32.5, y + 0.5});
    const double north_m = field.camera.eye_m.y - 2.0 * direction.y / direction.z;
    if (direction.z >= 0.0 || north_m > 99.0) continue;
    const float blue = canvas.radiance.pixel(32, y)[2];
    const bool is_inside = north_m > soft_m && north_m < 30.0 - soft_m;
    const bool is_outside = north_m > 30.0;
    inside += is_inside;
    outside += is_outside;
    if (is_inside || is_outside) {
      EXPECT_FLOAT_EQ(blue, is_inside ? 1.0F : 0.125F) << north_m;
    }
  }
  EXPECT_GT(inside, 5);
  EXPECT_GT(outside, 0);
}

TEST(Fog, HidesByBeersLaw) {
  const landscape::Landscape field = level_field();
  const Perspective perspective = perspective_of(field);
  Canvas canvas(side_px, side_px);
  paint_ground_and_sky(field, perspective, canvas);
  const landscape::Fog fog{0.1, glm::vec3(1.0F)};
  paint_fog(fog, perspective, canvas);
  const double distance_m = -2.0 / perspective.direction({32.5, 50.5}).z;
  const double left = std::exp(-0.1 * distance_m);
  EXPECT_NEAR(canvas.radiance.pixel(32, 50)[1], 0.5 * left + (1.0 - left), 1e-3);
  EXPECT_EQ(canvas.radiance.pixel(32, 0)[1], 1.0F);  // the sky is behind all of it
}

/// A volume of one extinction about the eye, which sends light of 1.
landscape::CloudBox volume_about(const glm::dvec3& eye_m, bool is_haze) {
  landscape::CloudBox box;
  box.voxels = glm::ivec3(128);
  box.voxel_m = 0.1;
  box.corner_m = eye_m - 6.4;
  box.extinction_per_m.assign(128 * 128 * 128, 0.1F);
  box.radiance.assign(128 * 128 * 128, glm::vec3(1.0F));
  box.is_haze = is_haze;
  return box;
}

TEST(Haze, HidesByBeersLawAsFarAsTheGround) {
  const landscape::Landscape field = level_field();
  const Perspective perspective = perspective_of(field);
  const auto painted = [&](bool is_haze) {
    Canvas canvas(side_px, side_px);
    paint_ground_and_sky(field, perspective, canvas);
    paint_haze({volume_about(field.camera.eye_m, is_haze)}, perspective, canvas);
    return canvas.radiance.pixel(32, 50)[1];
  };
  const double distance_m = -2.0 / perspective.direction({32.5, 50.5}).z;
  ASSERT_LT(distance_m, 6.0);
  const double left = std::exp(-0.1 * distance_m);
  EXPECT_NEAR(painted(true), 0.5 * left + (1.0 - left), 0.01);
  EXPECT_NEAR(painted(false), 0.5, 1e-3);  // clouds are in the sky's picture
}

/// What a flake that fills its square adds to a black canvas: its brightness times its area in px.
double painted(double distance_m, double half_m, float opacity, float behind_m) {
  const landscape::Landscape field = level_field();
  const Perspective perspective = perspective_of(field);
  const glm::dvec3 forward = glm::normalize(field.camera.target_m - field.camera.eye_m);
  landscape::Flakes flakes;
  flakes.pictures = {{"full", Image(4, 4, 1)}};
  std::fill(flakes.pictures[0].opacity.values.begin(), flakes.pictures[0].opacity.values.end(),
            1.0F);
  flakes.flakes = {{glm::vec3(field.camera.eye_m + distance_m * forward),
                    {float(half_m), 0.0F, 0.0F},
                    glm::vec3(half_m * glm::cross(glm::dvec3(1.0, 0.0, 0.0), forward)),
                    0,
                    opacity}};
  flakes.radiance = glm::vec3(1.0F);
  Canvas canvas(side_px, side_px);
  std::fill(canvas.depth_m.begin(), canvas.depth_m.end(), behind_m);
  paint_flakes(flakes, perspective, canvas);
  const std::vector<float>& values = canvas.radiance.values;
  return std::accumulate(values.begin(), values.end(), 0.0) / 3.0;
}

TEST(Flakes, CoverTheirAreaHoweverSmallTheyLook) {
  const double pixels_per_m = 0.5 * side_px / std::tan(std::numbers::pi / 6.0) / 2.0;  // at 2 m
  const double large = painted(2.0, 0.4, 0.5F, 1e9F);
  EXPECT_NEAR(large, 0.5 * std::pow(0.8 * pixels_per_m, 2), 0.08 * large);
  const double small = painted(2.0, 0.002, 0.5F, 1e9F);
  EXPECT_GT(small, 0.0);
  EXPECT_LT(small, 3.0 * 0.5 * std::pow(0.004 * pixels_per_m, 2));
  EXPECT_EQ(painted(2.0, 0.4, 0.5F, 1.5F), 0.0);  // behind something
}

TEST(Tubes, ShowTheirLightWhereNothingIsNearer) {
  const landscape::Landscape field = level_field();
  const Perspective perspective = perspective_of(field);
  // A three-sided mast of 1 m radius at the target, as high as the eye.
  Tubes mast{2, 3, {}, {glm::vec3(0.5F), glm::vec3(0.5F)}};
  for (const float z : {-2.0F, 2.0F})
    for (const float angle : {0.5F, 2.6F, 4.7F})
      mast.vertices_m.emplace_back(std::cos(angle), std::sin(angle), z);
  glm::dmat4 world_from_cell(1.0);
  world_from_cell[3] = glm::dvec4(50.0, 11.0, 0.0, 1.0);
  const auto light = [](const glm::dvec3&) { return glm::vec3(0.5F, 1.0F, 1.0F); };
  Canvas canvas(side_px, side_px);
  paint_tubes(mast, world_from_cell, light, perspective, canvas);
  const float* middle = canvas.radiance.pixel(32, 32);
  EXPECT_EQ(glm::vec3(middle[0], middle[1], middle[2]), glm::vec3(0.25F, 0.5F, 0.5F));
  EXPECT_NEAR(canvas.depth_at(32, 32), std::hypot(10.0, 2.0), 1.0);
  EXPECT_EQ(canvas.radiance.pixel(2, 32)[1], 0.0F);
  std::fill(canvas.depth_m.begin(), canvas.depth_m.end(), 5.0F);
  std::fill(canvas.radiance.values.begin(), canvas.radiance.values.end(), 0.0F);
  paint_tubes(mast, world_from_cell, light, perspective, canvas);
  EXPECT_EQ(canvas.radiance.pixel(32, 32)[1], 0.0F);
}

TEST(CameraPicture, IsEncodedAndLimited) {
  const Image picture = preview::camera_picture(level_field(), side_px);
  EXPECT_EQ(picture.height, side_px);
  EXPECT_NEAR(picture.pixel(32, 60)[1], srgb_encoded(0.5), 1e-5);
  landscape::Landscape bright = level_field();
  bright.exposure_gain = 100.0;
  EXPECT_NEAR(preview::camera_picture(bright, side_px).pixel(32, 60)[1], 1.0F, 1e-6);
}

}  // namespace
}  // namespace wold::test
