#include "snow/large_cover.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace wold::snow {
namespace {

using test::TemporaryFolder;

constexpr LargeCover::Limits small_tiles{64, 3, 4.0};

scene::Scene snowy_scene() {
  scene::Scene scene;
  scene.film.frame_seconds = 1e6;  // SnowGround's steps are hours then
  scene.snow_cover.initial_mm = 20.0;
  return scene;
}

/// Hills with slopes up to 50 degrees, from which snow slides into the hollows beside them.
Heightfield hills(int samples, double step_m = 20.0) {
  Heightfield terrain(samples, (samples - 1) * step_m);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i)
      terrain.at(i, j) = static_cast<float>(
          3.2 * step_m * std::sin(0.4 * i + 0.1 * j) * std::cos(0.3 * j) + 0.1 * step_m * j);
  return terrain;
}

WeatherMoment stormy(double time_s) {
  const double hours = time_s / 3600.0;
  return {-1.0 + 3.0 * std::sin(0.3 * hours), 15.0, 8.0, 40.0 * hours};
}

TEST(LargeCover, IsSnowGroundTileByTile) {
  const Heightfield terrain = hills(201);
  const TemporaryFolder folder("large_cover");
  LargeCover large(snowy_scene(), large_ground(terrain), stormy, folder.path(), small_tiles);
  const SnowGround whole(snowy_scene(), terrain, stormy);
  for (int hour : {0, 1, 30}) {
    large.integrate(hour);
    const SnowGround::State state = whole.at(3600.0 * hour);
    std::vector<float> values(201 * 201 * 3);
    const std::string name = hour == 0 ? "hour_00000" : hour == 1 ? "hour_00001" : "hour_00030";
    TiledImages(16.0).read(folder.path() / (name + "_level_0.tif"), {0, 0}, {201, 201}, 3, values);
    for (std::size_t i = 0; i < state.water_mm.values().size(); ++i) {
      ASSERT_NEAR(values[3 * i], state.water_mm.values()[i], 1e-5 * state.water_mm.values()[i])
          << hour << ' ' << i;
      ASSERT_NEAR(values[3 * i + 1], state.depth_m.values()[i], 1e-5 * state.depth_m.values()[i])
          << hour << ' ' << i;
    }
  }
}

TEST(LargeCover, ShowsNearGroundFinelyAndAllOfItCoarsely) {
  const Heightfield terrain = hills(201);
  const TemporaryFolder folder("large_cover");
  scene::Scene scene = snowy_scene();
  scene.snow_cover.initial_mm = 0.0;
  const auto flurry = [](double) { return WeatherMoment{-1.0, 0.8, 8.0, 75.0}; };
  LargeCover large(scene, large_ground(terrain), flurry, folder.path(), small_tiles);
  const SnowGround whole(scene, terrain, flurry);
  const glm::dvec2 eye_m(1300.0, 2900.0);
  const std::vector<CoverLevel> levels = large.view(5400.0, eye_m);
  const SnowGround::State before = whole.at(3600.0), after = whole.at(7200.0);
  const auto depth_m = [&](const glm::dvec2& at_m) {
    return 0.5 * (before.depth_m.sample(at_m.x, at_m.y) + after.depth_m.sample(at_m.x, at_m.y));
  };
  ASSERT_EQ(levels.size(), 3U);  // 201, 101 and 51 samples
  const CoverLevel& near = levels[0];
  EXPECT_EQ(near.side, 64);
  EXPECT_EQ(near.step_m, 20.0);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const glm::dvec2 at_m = near.first_m + glm::dvec2(x, y) * near.step_m;
      const double white = 0.5 * (cover_fraction(before.water_mm.sample(at_m.x, at_m.y)) +
                                  cover_fraction(after.water_mm.sample(at_m.x, at_m.y)));
      ASSERT_NEAR(near.white[y * 64 + x], white, 1e-5);
      ASSERT_NEAR(near.depth_m[y * 64 + x], depth_m(at_m), 1e-6);
    }
  const glm::dvec2 middle_m = near.first_m + 32.0 * near.step_m;
  EXPECT_LE(glm::length(middle_m - eye_m), 8 * 20.0);
  const CoverLevel& far = levels[2];
  EXPECT_EQ(far.side, 51);
  EXPECT_EQ(far.first_m, glm::dvec2(30.0));  // in the middle of four by four samples
  double mean = 0.0;
  for (int j = 40; j < 44; ++j)
    for (int i = 80; i < 84; ++i) mean += depth_m(glm::dvec2(i, j) * 20.0) / 16.0;
  EXPECT_NEAR(far.depth_m[10 * 51 + 20], mean, 1e-6);
}

TEST(LargeCover, IsTheSameHoweverItIsAskedAndKeepsTwoHoursOnDisk) {
  const Heightfield terrain = hills(130);
  const TemporaryFolder one("cover_in_turn"), other("cover_alone");
  LargeCover in_turn(snowy_scene(), large_ground(terrain), stormy, one.path(), small_tiles);
  LargeCover alone(snowy_scene(), large_ground(terrain), stormy, other.path(), small_tiles);
  for (int frame = 0; frame < 9; ++frame) in_turn.view(1800.0 * frame, {100.0, 50.0 * frame});
  const auto a = in_turn.view(9000.0, {100.0, 400.0});  // back in time
  const auto b = alone.view(9000.0, {100.0, 400.0});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t level = 0; level < a.size(); ++level) {
    EXPECT_EQ(a[level].depth_m, b[level].depth_m);
    EXPECT_EQ(a[level].white, b[level].white);
    EXPECT_EQ(a[level].albedo, b[level].albedo);
  }
  const auto files = std::distance(std::filesystem::directory_iterator(one.path()), {});
  const int winds = 5;  // of the hours before 5 h, 40 degrees apart
  EXPECT_EQ(files, 2 * static_cast<int>(a.size()) + winds + 1);
}

// Bare ground is passed in one go up to the first snow, and that is none too late.
TEST(LargeCover, PassesBareGroundUpToTheFirstSnow) {
  constexpr int first_snow_h = 100;
  scene::Scene bare = snowy_scene();
  bare.snow_cover.initial_mm = 0.0;
  std::atomic<int> rounds = 0;
  const auto late = [&](double time_s) {
    rounds += 1;
    return time_s < 3600.0 * first_snow_h ? WeatherMoment{12.0, 4.0, 8.0, 75.0} : stormy(time_s);
  };
  const Heightfield terrain = hills(201);
  const TemporaryFolder folder("late_snow");
  LargeCover large(bare, large_ground(terrain), late, folder.path(), small_tiles);
  large.integrate(first_snow_h);
  EXPECT_EQ(rounds, 2 * first_snow_h);  // looked at, then passed
  large.integrate(first_snow_h + 2);
  std::vector<float> values(201 * 201 * 3);
  TiledImages(16.0).read(folder.path() / "hour_00102_level_0.tif", {0, 0}, {201, 201}, 3, values);
  const SnowGround::State want = SnowGround(bare, terrain, late).at(3600.0 * (first_snow_h + 2.0));
  EXPECT_GT(want.fallen_mm, 1.0);
  for (std::size_t i = 0; i < want.water_mm.values().size(); ++i)
    ASSERT_NEAR(values[3 * i], want.water_mm.values()[i], 1e-5 * want.water_mm.values()[i]) << i;
}

TEST(LargeCover, HoldsNoMoreGroundThanItsTiles) {
  const Heightfield terrain = hills(600);
  LargeGround ground = large_ground(terrain);
  std::atomic<int> largest = 0;
  ground.heights = [&, read = ground.heights](const glm::ivec2& first, int side,
                                              std::span<float> heights_m) {
    largest = std::max(largest.load(), side);
    read(first, side, heights_m);
  };
  const TemporaryFolder folder("large_cover");
  LargeCover(snowy_scene(), ground, stormy, folder.path(), small_tiles).integrate(1);
  EXPECT_EQ(largest, 64 + 2 * (16 + 5));
}

TEST(LargeCover, RefusesOrToleratesOddGround) {
  const TemporaryFolder folder("large_cover");
  Heightfield terrain = hills(100);
  terrain.at(70, 90) = std::nanf("");
  try {
    LargeCover(snowy_scene(), large_ground(terrain), stormy, folder.path(), small_tiles);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("column 70 of row 90"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));

  const Heightfield cell(2, 30.0, 100.0F);
  LargeCover min(snowy_scene(), large_ground(cell), stormy, folder.path(), small_tiles);
  const auto levels = min.view(1800.0, {0.0, 0.0});
  ASSERT_EQ(levels.size(), 1U);
  EXPECT_EQ(levels[0].side, 2);
  EXPECT_GT(levels[0].white[3], 0.9F);

  const Heightfield level_ground(100, 990.0, 100.0F);
  EXPECT_THROW(LargeCover(snowy_scene(), large_ground(level_ground), stormy,
                          folder.path() / "missing", small_tiles),
               FileError);
}

}  // namespace
}  // namespace wold::snow
