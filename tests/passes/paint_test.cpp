#include "passes/paint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "core/files.h"
#include "core/parallel.h"
#include "core/vdb_dense.h"
#include "landscape/perspective.h"
#include "passes/ground_cast.h"
#include "passes/standing_grass.h"
#include "support/constant_meadow.h"
#include "support/plain_facts.h"
#include "support/quartered.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"

namespace wold::passes {
namespace {

using landscape::Landscape;

constexpr float no_depth = 1e10F;

/// The passes of a landscape, pixel by pixel.
class Painted {
 public:
  Painted(const Landscape& landscape, const GroundFacts& facts)
      : landscape_(landscape),
        image_(paint(landscape, facts, passes_of("all"))),
        perspective_(landscape.camera, {landscape.width_px, landscape.height_px}) {}
  explicit Painted(const Landscape& landscape) : Painted(landscape, test::plain_facts(landscape)) {}

  const LayeredImage& image() const { return image_; }
  std::size_t pixels() const { return image_.pixels(); }
  float value(const char* channel, std::size_t pixel) const {
    return image_.find(channel)->values.at(pixel);
  }
  glm::dvec3 vector(const std::string& layer, const char* letters, std::size_t pixel) const {
    glm::dvec3 vector;
    for (int axis = 0; axis < 3; ++axis)
      vector[axis] = image_.find(layer + "." + letters[axis])->values.at(pixel);
    return vector;
  }
  glm::dvec3 direction(std::size_t pixel, const glm::dvec2& from_middle = {}) const {
    const auto width = static_cast<std::size_t>(landscape_.width_px);
    return perspective_.direction(glm::dvec2(pixel % width, pixel / width) + 0.5 + from_middle);
  }
  /// Along the ray.
  double distance_m(std::size_t pixel) const {
    return value("depth.Z", pixel) / perspective_.depth_along(direction(pixel));
  }
  bool shows_nothing(std::size_t pixel) const { return value("depth.Z", pixel) == no_depth; }

 private:
  const Landscape& landscape_;
  LayeredImage image_;
  landscape::Perspective perspective_;
};

/// Of fog on level ground that lies at 0.
Landscape level_fog(const test::ConstantMeadow& fog, const std::filesystem::path& folder) {
  Landscape landscape = test::constant_meadow(fog, folder);
  for (float& height_m : landscape.terrain.values()) height_m = 0.0F;
  landscape.blade_cells.clear();
  landscape.cells.clear();
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) {
      glm::dmat4 world_from_cell(1.0);
      world_from_cell[3] = {i * 0.5, j * 0.5, 0.0, 1.0};
      landscape.cells.push_back({world_from_cell, 0, glm::dmat4(1.0), {}, {{i, j}, 0}});
    }
  return landscape;
}

Landscape bare(Landscape landscape) {
  landscape.cells.clear();
  landscape.blade_cells.clear();
  return landscape;
}

TEST(Passes, APlaneHasItsDepthNormalAndPlace) {
  const test::TemporaryFolder folder("passes_plane");
  Landscape landscape = bare(test::constant_meadow({}, folder.path()));
  for (int j = 0; j < landscape.terrain.samples(); ++j)
    for (int i = 0; i < landscape.terrain.samples(); ++i) {
      const glm::dvec2 at_m = landscape.terrain.place_m(i, j);
      landscape.terrain.at(i, j) = static_cast<float>(0.1 * at_m.x - 0.05 * at_m.y);
    }
  const Painted painted(landscape);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.1, 0.05, 1.0));
  const glm::dvec3& eye_m = landscape.camera.eye_m;
  int seen = 0;
  for (std::size_t pixel = 0; pixel < painted.pixels(); ++pixel) {
    const glm::dvec3 along = painted.direction(pixel);
    const double want_m = -glm::dot(eye_m, normal) / glm::dot(along, normal);
    const glm::dvec3 at_m = eye_m + want_m * along;
    const bool on_it = want_m > 0.0 && glm::all(glm::greaterThan(glm::dvec2(at_m), {0, 0})) &&
                       glm::all(glm::lessThan(glm::dvec2(at_m), {3, 3}));
    ASSERT_EQ(painted.shows_nothing(pixel), !on_it) << pixel;
    if (!on_it) continue;
    ++seen;
    ASSERT_NEAR(painted.distance_m(pixel), want_m, 1e-5);
    ASSERT_LT(glm::distance(painted.vector("position", "XYZ", pixel), at_m), 1e-5);
    ASSERT_LT(glm::distance(painted.vector("normal", "XYZ", pixel), normal), 1e-3);
  }
  EXPECT_GT(seen, 1000);
}

/// Where a ray meets the ground between its samples, bilinear as a Landscape has it, by steps of a
/// millimetre.
double stepped_m(const Heightfield& terrain, const glm::dvec3& eye_m, const glm::dvec3& along) {
  for (double at_m = 0.0; at_m < 6.0; at_m += 1e-3) {
    const glm::dvec3 here_m = eye_m + at_m * along;
    const glm::dvec2 place(here_m);
    if (glm::any(glm::lessThan(place, {0, 0})) || glm::any(glm::greaterThan(place, {3, 3})))
      continue;
    if (here_m.z <= double{terrain.sample(place.x, place.y)}) return at_m - 5e-4;
  }
  return std::numeric_limits<double>::infinity();
}

TEST(Passes, DepthIsThatOfARayFollowedInSteps) {
  const test::TemporaryFolder folder("passes_witness");
  const Landscape landscape = bare(test::synthetic_landscape({}, folder.path()));
  const Painted painted(landscape);
  int seen = 0;
  for (std::size_t pixel = 0; pixel < painted.pixels(); pixel += 7) {
    if (painted.shows_nothing(pixel)) continue;
    const double want_m =
        stepped_m(landscape.terrain, landscape.camera.eye_m, painted.direction(pixel));
    if (!std::isfinite(want_m)) continue;  // the rim
    ++seen;
    ASSERT_NEAR(painted.distance_m(pixel), want_m, 1e-3 + 1e-3 * want_m) << pixel;
  }
  EXPECT_GT(seen, 1500);
}

/// A ray's way through the fog.
struct FogWay {
  double first_m, last_m;
  bool is_whole;  ///< it enters from above and leaves into the ground
};

FogWay through_fog(const test::ConstantMeadow& fog, const glm::dvec3& eye_m,
                   const glm::dvec3& along) {
  const double top_m = fog.height_voxels * 0.5 / fog.voxels;
  FogWay way{(top_m - eye_m.z) / along.z, -eye_m.z / along.z, along.z < 0.0};
  for (const double at_m : {way.first_m, way.last_m}) {
    const glm::dvec2 place(eye_m + at_m * along);
    way.is_whole = way.is_whole && glm::all(glm::greaterThan(place, {0.01, 0.01})) &&
                   glm::all(glm::lessThan(place, {2.99, 2.99}));
  }
  return way;
}

TEST(Passes, FogIsSeenWhereItHidesHalf) {
  const test::TemporaryFolder folder("passes_fog");
  const test::ConstantMeadow fog = {.extinction = 0.9F};
  const Landscape landscape = level_fog(fog, folder.path());
  const Painted painted(landscape);
  const double half_m = std::log(2.0) / double{fog.extinction};
  const glm::dvec3& eye_m = landscape.camera.eye_m;
  int grassy = 0, on_ground = 0;
  for (std::size_t pixel = 0; pixel < painted.pixels(); ++pixel) {
    const glm::dvec3 along = painted.direction(pixel);
    const FogWay way = through_fog(fog, eye_m, along);
    if (!way.is_whole) continue;
    const bool hides_half = way.last_m - way.first_m > half_m;
    (hides_half ? grassy : on_ground) += 1;
    const double want_m = hides_half ? way.first_m + half_m : way.last_m;
    ASSERT_NEAR(painted.distance_m(pixel), want_m, 1e-5) << pixel;
    const glm::dvec2 cell = glm::floor(glm::dvec2(eye_m + want_m * along) / 0.5);
    EXPECT_EQ(painted.value("instance.X", pixel), hides_half ? cell.x : -1.0);
    EXPECT_EQ(painted.value("instance.Y", pixel), hides_half ? cell.y : -1.0);
  }
  EXPECT_GT(grassy, 300);
  EXPECT_GT(on_ground, 100);
}

// As shrubs and the grass around them: not one behind the other.
TEST(Passes, FogsOfOnePlaceAreSeenWhereTheyHideHalfTogether) {
  const test::TemporaryFolder folder("passes_fogs");
  const test::ConstantMeadow fog = {.extinction = 0.9F};
  Landscape landscape = level_fog(fog, folder.path());
  const std::vector<landscape::Cell> once = landscape.cells;
  landscape.cells.insert(landscape.cells.end(), once.begin(), once.end());
  const Painted painted(landscape);
  const double half_m = std::log(2.0) / (2.0 * double{fog.extinction});
  const double slice_m = 0.5 / fog.voxels;
  int grassy = 0;
  for (std::size_t pixel = 0; pixel < painted.pixels(); ++pixel) {
    const FogWay way = through_fog(fog, landscape.camera.eye_m, painted.direction(pixel));
    if (!way.is_whole || way.last_m - way.first_m < half_m + slice_m) continue;
    ++grassy;
    ASSERT_NEAR(painted.distance_m(pixel), way.first_m + half_m, slice_m) << pixel;
  }
  EXPECT_GT(grassy, 300);
}

TEST(Passes, FogCoversWhatItsLengthSays) {
  const test::TemporaryFolder folder("passes_cover");
  const test::ConstantMeadow fog;
  const Landscape landscape = level_fog(fog, folder.path());
  const Painted painted(landscape);
  int seen = 0;
  for (std::size_t pixel = 0; pixel < painted.pixels(); ++pixel) {
    double want = 0.0;
    bool is_whole = true;
    for (int k = 0; k < 16; ++k) {
      const glm::dvec2 from_middle((k % 4 + 0.5) / 4.0 - 0.5, (k / 4 + 0.5) / 4.0 - 0.5);
      const FogWay way =
          through_fog(fog, landscape.camera.eye_m, painted.direction(pixel, from_middle));
      is_whole = is_whole && way.is_whole;
      want += (1.0 - std::exp(-double{fog.extinction} * (way.last_m - way.first_m))) / 16.0;
    }
    if (!is_whole) continue;
    ++seen;
    // Rays end at a thousandth.
    ASSERT_NEAR(painted.value("species00.G", pixel), want, 1e-3) << pixel;
    ASSERT_NEAR(painted.value("species00.A", pixel), 1.0 - want, 1e-3) << pixel;
    ASSERT_FLOAT_EQ(painted.value("depth.A", pixel), 1.0F);
  }
  EXPECT_GT(seen, 200);
}

/// The part of a ray that grass lets through: small steps through the cells' own spaces, however
/// the code under test divides them.
double let_through(const Landscape& landscape, const std::vector<std::vector<float>>& densities,
                   const glm::dvec3& along, double end_m) {
  constexpr double step_m = 5e-4;
  double depth = 0.0;
  for (double at_m = 0.5 * step_m; at_m < std::min(end_m, 6.0); at_m += step_m) {
    const glm::dvec3 here_m = landscape.camera.eye_m + at_m * along;
    for (const landscape::Cell& cell : landscape.cells) {
      const glm::dvec2 from_corner_m = glm::dvec2(here_m) - glm::dvec2(cell.world_from_cell[3]);
      const glm::dvec2 below =  // in patches
          glm::inverse(glm::dmat2(cell.world_from_cell)) * from_corner_m / landscape.patch_m;
      if (glm::any(glm::notEqual(glm::floor(below), glm::dvec2(0.0)))) continue;
      const glm::dvec3 in_cell(glm::inverse(cell.world_from_cell) * glm::dvec4(here_m, 1.0));
      const auto number = static_cast<std::size_t>(cell.volume);
      const landscape::Volume& volume = landscape.volumes[number];
      glm::ivec3 voxel(glm::floor(in_cell / volume.voxel_m));
      if (voxel.z < 0 || voxel.z >= volume.voxels.z) continue;
      for (int axis = 0; axis < 2; ++axis)
        voxel[axis] = (voxel[axis] % volume.voxels.x + volume.voxels.x) % volume.voxels.x;
      depth += step_m * double{densities[number][static_cast<std::size_t>(
                            (voxel.z * volume.voxels.y + voxel.y) * volume.voxels.x + voxel.x)]};
    }
  }
  return std::exp(-depth);
}

TEST(Passes, GrassHidesWhatItsVoxelsHide) {
  const test::TemporaryFolder folder("passes_voxels");
  Landscape landscape = test::synthetic_landscape({}, folder.path());
  landscape.blade_cells.clear();
  for (landscape::Cell& cell : landscape.cells) {  // rows rise, and the wind leans them
    for (const int column : {0, 1, 3})
      cell.world_from_cell[column].y += 0.15 * cell.world_from_cell[column].x;
    cell.world_from_cell[2].x = 0.3;
    cell.world_from_cell[2].y = -0.2;
  }
  const std::vector<landscape::Cell> on_grid = landscape.cells;
  for (landscape::Cell shrub : on_grid) {  // beside its cell, and larger
    for (int axis = 0; axis < 3; ++axis) shrub.world_from_cell[axis] *= 1.2;
    shrub.world_from_cell[3] += glm::dvec4(0.2, 0.15, 0.0, 0.0);
    landscape.cells.push_back(shrub);
  }
  std::vector<std::vector<float>> densities;
  for (const landscape::Volume& volume : landscape.volumes)
    densities.push_back(read_dense_floats(volume.vdb, "density", glm::ivec3(1), volume.voxels));
  const StandingGrass grass(landscape);
  const GroundCast ground(landscape.terrain);
  const landscape::Perspective perspective(landscape.camera, {24, 14});
  GrassSight sight;
  double difference = 0.0, hidden = 0.0;
  int rays = 0;
  for (int y = 4; y < 14; ++y)
    for (int x = 0; x < 24; ++x) {
      const glm::dvec3 along = perspective.direction(glm::dvec2(x, y) + 0.5);
      const double end_m = ground.distance_m(landscape.camera.eye_m, along);
      grass.look(landscape.camera.eye_m, along, end_m, sight);
      const double got = std::exp(-sight.optical_depth);
      const double want = let_through(landscape, densities, along, end_m);
      difference += got - want;
      hidden += 1.0 - want;
      ++rays;
      ASSERT_NEAR(got, want, 0.02) << x << " " << y;
    }
  EXPECT_GT(hidden / rays, 0.3);
  EXPECT_NEAR(difference / rays, 0.0, 1e-3);
}

TEST(Passes, PartsOfCellsShowWhatTheWholeShows) {
  const test::TemporaryFolder folder("passes_parts");
  Landscape landscape = test::synthetic_landscape({}, folder.path());
  landscape.blade_cells.clear();
  const Painted whole(landscape);
  test::quarter_cells(landscape);
  const Painted parts(landscape);
  for (std::size_t pixel = 0; pixel < whole.pixels(); ++pixel) {
    ASSERT_NEAR(parts.value("depth.A", pixel), whole.value("depth.A", pixel), 1e-3) << pixel;
    if (whole.shows_nothing(pixel)) continue;
    ASSERT_NEAR(parts.distance_m(pixel), whole.distance_m(pixel), 1e-5) << pixel;
  }
}

TEST(Passes, AStepToTheSideMovesTheGroundByItsDepth) {
  const test::TemporaryFolder folder("passes_motion");
  const Landscape landscape = bare(test::constant_meadow({}, folder.path()));
  GroundFacts facts = test::plain_facts(landscape);
  facts.next_camera.eye_m.x += 0.1;
  facts.next_camera.target_m.x += 0.1;
  const Painted painted(landscape, facts);
  const double focal_px = 0.5 * landscape.width_px / std::tan(glm::radians(25.0));
  for (std::size_t pixel = 0; pixel < painted.pixels(); ++pixel) {
    const double want_px =
        painted.shows_nothing(pixel) ? 0.0 : -0.1 * focal_px / painted.value("depth.Z", pixel);
    ASSERT_NEAR(painted.value("motion.X", pixel), want_px, 1e-4) << pixel;
    ASSERT_NEAR(painted.value("motion.Y", pixel), 0.0, 1e-4) << pixel;
  }
}

// The next frame's own passes have the same places where motion says that they will be.
TEST(Passes, MotionLeadsToTheSamePlaceInTheNextFrame) {
  const test::TemporaryFolder folder("passes_motion_next");
  Landscape landscape = bare(test::synthetic_landscape({}, folder.path()));
  GroundFacts facts = test::plain_facts(landscape);
  facts.next_camera.eye_m += glm::dvec3(0.05, 0.1, 0.02);
  facts.next_camera.target_m += glm::dvec3(-0.1, 0.0, 0.03);
  const Painted now(landscape, facts);
  Landscape later = landscape;
  later.camera = facts.next_camera;
  const Painted next(later);
  const int width = landscape.width_px;
  int seen = 0;
  for (std::size_t pixel = 0; pixel < now.pixels(); pixel += 3) {
    if (now.shows_nothing(pixel)) continue;
    const glm::dvec2 to_px =
        glm::dvec2(static_cast<int>(pixel) % width, static_cast<int>(pixel) / width) +
        glm::dvec2(now.value("motion.X", pixel), now.value("motion.Y", pixel));
    const glm::ivec2 at(glm::round(to_px));
    if (at.x < 0 || at.y < 0 || at.x >= width || at.y >= landscape.height_px) continue;
    const auto there = static_cast<std::size_t>(at.y * width + at.x);
    if (next.shows_nothing(there)) continue;
    const glm::dvec3 moved_m =
        next.vector("position", "XYZ", there) - now.vector("position", "XYZ", pixel);
    // Half a pixel to a side, and what lies behind a crest may come forth.
    if (glm::length(moved_m) < 0.05 * next.value("depth.Z", there)) ++seen;
  }
  EXPECT_GT(seen, static_cast<int>(now.pixels()) / 3 / 3);
}

// A step ahead takes the camera past the ground that it sees at its feet: that goes on as it went.
TEST(Passes, WhatTheNextCameraHasPassedGoesOnAsItWent) {
  const test::TemporaryFolder folder("passes_passed");
  Landscape landscape = bare(test::constant_meadow({}, folder.path()));
  for (float& height_m : landscape.terrain.values()) height_m = 0.0F;
  landscape.camera = {{1.5, 0.5, 0.5}, {1.5, 1.0, 0.25}, 60.0};
  const auto after_step = [&](double step_m) {
    GroundFacts facts = test::plain_facts(landscape);
    facts.next_camera.eye_m.y += step_m;
    facts.next_camera.target_m.y += step_m;
    return Painted(landscape, facts);
  };
  const Painted far = after_step(1.5), near = after_step(1e-3);
  const std::size_t bottom = far.pixels() - static_cast<std::size_t>(landscape.width_px) / 2;
  ASSERT_FALSE(far.shows_nothing(bottom));
  for (std::size_t pixel = 0; pixel < far.pixels(); ++pixel)
    ASSERT_TRUE(std::isfinite(far.value("motion.Y", pixel))) << pixel;
  const double at_first_px = 1500.0 * near.value("motion.Y", bottom);
  EXPECT_GT(far.value("motion.Y", bottom), at_first_px);  // faster and faster, and down
  EXPECT_LT(far.value("motion.Y", bottom), 12.0 * at_first_px);
}

TEST(Passes, TheSkyMovesAsTheCameraTurns) {
  const test::TemporaryFolder folder("passes_sky");
  const Landscape landscape = bare(test::constant_meadow({}, folder.path()));
  GroundFacts facts = test::plain_facts(landscape);
  facts.next_camera.eye_m += glm::dvec3(3.0, -5.0, 1.0);
  facts.next_camera.target_m += glm::dvec3(3.0, -5.0, 1.0);
  const Painted walks(landscape, facts);
  ASSERT_TRUE(walks.shows_nothing(0));
  EXPECT_NEAR(walks.value("motion.X", 0), 0.0, 1e-4);
  EXPECT_NEAR(walks.value("motion.Y", 0), 0.0, 1e-4);
  facts.next_camera = landscape.camera;
  facts.next_camera.target_m.x += 0.01;  // it turns to the right: all goes to the left
  EXPECT_LT(Painted(landscape, facts).value("motion.X", 0), -0.1F);
}

TEST(Passes, NothingMovesBeforeAStillCamera) {
  const test::TemporaryFolder folder("passes_still");
  const Landscape landscape = bare(test::synthetic_landscape({}, folder.path()));
  const Painted painted(landscape);
  for (const char* channel : {"motion.X", "motion.Y"})
    for (const float px : painted.image().find(channel)->values) ASSERT_EQ(px, 0.0F);
}

TEST(Passes, GrassThatWavesGoesByItsLeanAndItsHeight) {
  const test::TemporaryFolder folder("passes_sway");
  const Landscape landscape = level_fog({.extinction = 20.0F}, folder.path());
  GroundFacts facts = test::plain_facts(landscape);
  facts.more_lean = [](const glm::ivec2& cell) {
    return cell.x < 3 ? glm::dvec2(0.2, -0.1) : glm::dvec2(0.0);
  };
  const Painted painted(landscape, facts);
  const landscape::Perspective eye(landscape.camera, {landscape.width_px, landscape.height_px});
  int swaying = 0;
  for (std::size_t pixel = 0; pixel < painted.pixels(); ++pixel) {
    const float column = painted.value("instance.X", pixel);
    const bool sways = column >= 0.0F && column < 3.0F;
    glm::dvec2 want_px(0.0);
    if (sways) {
      const glm::dvec3 at_m = painted.vector("position", "XYZ", pixel);
      want_px = glm::dvec2(eye.seen(at_m + at_m.z * glm::dvec3(0.2, -0.1, 0.0))) -
                glm::dvec2(eye.seen(at_m));
      swaying += glm::length(want_px) > 0.5 ? 1 : 0;
    }
    ASSERT_NEAR(painted.value("motion.X", pixel), want_px.x, 1e-3) << pixel;
    ASSERT_NEAR(painted.value("motion.Y", pixel), want_px.y, 1e-3) << pixel;
  }
  EXPECT_GT(swaying, 200);
}

TEST(Passes, MapsAreReadWhereThePixelLooks) {
  const test::TemporaryFolder folder("passes_maps");
  const Landscape landscape = bare(test::synthetic_landscape({}, folder.path()));
  GroundFacts facts = test::plain_facts(landscape);
  facts.snow_m = [](const glm::dvec2& at_m) { return at_m.x; };
  facts.weathering = [](const glm::dvec2& at_m) { return at_m.y / 4.0; };
  facts.wetness = [](const glm::dvec2& at_m) { return at_m.x * at_m.y / 16.0; };
  facts.albedo = [](const glm::dvec2& at_m) { return glm::vec3(at_m.x / 4.0, 0.5, at_m.y / 4.0); };
  facts.irradiance = [](const glm::dvec2& at_m) { return glm::vec3(at_m.y, at_m.x, 2.0); };
  const Painted painted(landscape, facts);
  for (std::size_t pixel = 0; pixel < painted.pixels(); ++pixel) {
    if (painted.shows_nothing(pixel)) {
      EXPECT_EQ(painted.value("snow.V", pixel), 0.0F);
      EXPECT_EQ(painted.vector("light", "RGB", pixel), glm::dvec3(0.0));
      continue;
    }
    const glm::dvec3 at_m = painted.vector("position", "XYZ", pixel);
    ASSERT_NEAR(painted.value("snow.V", pixel), at_m.x, 1e-5);
    ASSERT_NEAR(painted.value("weathering.V", pixel), at_m.y / 4.0, 1e-5);
    ASSERT_NEAR(painted.value("wetness.V", pixel), at_m.x * at_m.y / 16.0, 1e-5);
    ASSERT_NEAR(painted.vector("albedo", "RGB", pixel).b, at_m.y / 4.0, 1e-5);
    ASSERT_NEAR(painted.vector("light", "RGB", pixel).g, at_m.x, 1e-5);
  }
}

TEST(Passes, LeavesHaveTheirTexelsAlbedo) {
  const test::TemporaryFolder folder("passes_albedo");
  const Landscape landscape = level_fog({}, folder.path());
  const Painted painted(landscape);
  const double leaf{test::ConstantMeadow().radiance};  // which its texel has for an albedo
  int leaves = 0;
  for (std::size_t pixel = 0; pixel < painted.pixels(); ++pixel) {
    if (painted.shows_nothing(pixel)) continue;
    const bool is_leaf = painted.value("instance.X", pixel) >= 0.0F;
    leaves += is_leaf ? 1 : 0;
    ASSERT_NEAR(painted.vector("albedo", "RGB", pixel).g, is_leaf ? leaf : 0.5, 1e-4) << pixel;
  }
  EXPECT_GT(leaves, 300);
}

TEST(Passes, LeavesHaveTheAlbedoOfTheirHeight) {
  const test::TemporaryFolder folder("passes_leaves");
  const test::SyntheticMeadow meadow;
  Landscape landscape = test::synthetic_landscape(meadow, folder.path());
  landscape.blade_cells.clear();
  for (std::size_t i = 0; i < landscape.cells.size(); ++i)
    landscape.cells[i].origin.cell = {i % 6, i / 6};
  const Painted painted(landscape);
  int leaves = 0;
  for (std::size_t pixel = 0; pixel < painted.pixels(); ++pixel) {
    const glm::ivec2 at(painted.value("instance.X", pixel), painted.value("instance.Y", pixel));
    if (at.x < 0) continue;
    const glm::dmat4& world_from_cell =
        landscape.cells[static_cast<std::size_t>(at.y * 6 + at.x)].world_from_cell;
    const glm::dvec3 at_m = painted.vector("position", "XYZ", pixel);
    const double height =
        (glm::inverse(world_from_cell) * glm::dvec4(at_m, 1.0)).z * meadow.voxels / 0.5;
    if (std::abs(height - std::round(height)) < 1e-3) continue;  // between two voxels
    ++leaves;
    const double want = 0.10 * (0.3 + (std::floor(height) + 0.5) / meadow.height_voxels);
    // A blade may end in the middle of a voxel.
    ASSERT_NEAR(painted.vector("albedo", "RGB", pixel).g, want, 0.003) << pixel;
  }
  EXPECT_GT(leaves, 3000);
}

TEST(Passes, SnowAndPaintedGrassCoverTheGroundByName) {
  const test::TemporaryFolder folder("passes_names");
  const Landscape landscape = bare(test::constant_meadow({}, folder.path()));
  GroundFacts facts = test::plain_facts(landscape);
  facts.species = {"sedge", "moss"};
  facts.mixtures = {{1.0, 0.0}, {0.25, 0.75}};
  facts.painted_grass = [](const glm::dvec3&) { return PaintedGrass{1, 0.8}; };
  facts.white_fraction = [](const glm::dvec2&) { return 0.75; };
  const Painted painted(landscape, facts);
  const std::size_t pixel = painted.pixels() - 10;
  ASSERT_FALSE(painted.shows_nothing(pixel));
  EXPECT_NEAR(painted.value("species00.G", pixel), 0.6, 1e-6);   // moss
  EXPECT_NEAR(painted.value("species00.A", pixel), 0.2, 1e-6);   // sedge
  EXPECT_NEAR(painted.value("species01.G", pixel), 0.15, 1e-6);  // snow
  EXPECT_NEAR(painted.value("species01.A", pixel), 0.05, 1e-6);  // ground
}

TEST(Passes, AreTheSameBytesWithAnyNumberOfThreads) {
  const test::TemporaryFolder folder("passes_threads");
  Landscape landscape = test::synthetic_landscape({}, folder.path() / "texels");
  landscape.blade_cells.clear();
  std::vector<std::string> bytes;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    const std::filesystem::path file = folder.path() / "passes.exr";
    write_layered_image(file, Painted(landscape).image());
    bytes.push_back(read_file(file));
  }
  EXPECT_EQ(bytes[0], bytes[1]);
  EXPECT_EQ(bytes[0], bytes[2]);
}

TEST(Passes, AreOnlyThoseThatAreAskedFor) {
  const test::TemporaryFolder folder("passes_some");
  const Landscape landscape = bare(test::constant_meadow({}, folder.path()));
  const LayeredImage image =
      paint(landscape, test::plain_facts(landscape), passes_of("snow,depth"));
  std::vector<std::string> names;
  for (const ImageChannel& channel : image.channels) names.push_back(channel.name);
  EXPECT_THAT(names, testing::ElementsAre("depth.Z", "depth.A", "snow.V"));
  EXPECT_THAT(image.attributes.at("wold/depth"), testing::StartsWith("m; "));
  EXPECT_EQ(image.attributes.count("wold/normal"), 0U);
}

TEST(PassNames, AreReadFromLists) {
  EXPECT_THAT(passes_of("snow,depth,snow"), testing::ElementsAre(Pass::depth, Pass::snow));
  EXPECT_EQ(passes_of("all").size(), all_passes().size());
  EXPECT_EQ(text_of(passes_of("snow,depth")), "depth,snow");
  EXPECT_EQ(text_of(passes_of("all")), "all");
}

TEST(PassNames, UnknownOnesAreRefusedWithWhatThereIs) {
  for (const char* text : {"dept", "", "depth,", ",", "depth, snow", "all,x"}) try {
      passes_of(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("depth, normal, position, motion, species"));
    }
}

// A block of half a metre in the middle of level ground.
TEST(Passes, BouldersAreGroundThatStandsOutOfIt) {
  const test::TemporaryFolder folder("passes_boulder");
  Landscape landscape = bare(test::constant_meadow({}, folder.path()));
  for (float& height_m : landscape.terrain.values()) height_m = 0.0F;
  landscape.boulders.points_m = {{1.25F, 1.25F, 0.5F}, {1.75F, 1.25F, 0.5F}, {1.75F, 1.75F, 0.5F},
                                 {1.25F, 1.75F, 0.5F}, {1.25F, 1.0F, -0.1F}, {1.75F, 1.0F, -0.1F}};
  landscape.boulders.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 1}, {4, 1, 0}};
  const Painted painted(landscape);
  const glm::dvec3 side = glm::normalize(glm::dvec3(0.0, -0.6, 0.25));
  int on_top = 0, on_side = 0;
  for (std::size_t pixel = 0; pixel < painted.pixels(); ++pixel) {
    if (painted.shows_nothing(pixel)) continue;
    const glm::dvec3 at_m = painted.vector("position", "XYZ", pixel);
    const glm::dvec3 normal = painted.vector("normal", "XYZ", pixel);
    if (at_m.z > 0.499) {
      ++on_top;
      EXPECT_GT(normal.z, 0.999);
    } else if (at_m.z > 1e-4) {
      ++on_side;
      EXPECT_LT(glm::distance(normal, side), 1e-2);
    } else if (at_m.y < 1.0) {
      EXPECT_GT(normal.z, 0.999);
    }
  }
  EXPECT_GT(on_top + on_side, 50);
  EXPECT_GT(on_side, 10);
}

}  // namespace
}  // namespace wold::passes
