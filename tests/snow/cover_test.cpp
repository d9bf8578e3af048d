#include "snow/cover.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/error.h"

namespace wold::snow {
namespace {

scene::Scene snowy_scene() {
  scene::Scene scene;
  scene.film.frame_seconds = 1800.0;
  scene.ageing.frames.assign(48, 0.0);
  scene.weather.earlier_h = 6.5;
  scene.snow_cover.initial_mm = 2.0;
  return scene;
}

Heightfield hillside(int samples = 49, double size_m = 480.0) {
  Heightfield terrain(samples, size_m);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const double x = i * terrain.step_m(), y = j * terrain.step_m();
      terrain.at(i, j) = static_cast<float>(0.8 * y + 15.0 * std::sin(0.03 * x + 0.01 * y));
    }
  return terrain;
}

/// Snow that turns to rain from below and a wind that turns.
WeatherMoment changing(double time_s) {
  const double hours = time_s / 3600.0;
  return {1.5 + 3.0 * std::sin(0.5 * hours), 2.0 + std::sin(hours), 4.0, 20.0 * hours};
}

bool same(const SnowGround::State& a, const SnowGround::State& b) {
  return a.depth_m.values() == b.depth_m.values() && a.water_mm.values() == b.water_mm.values() &&
         a.albedo.values() == b.albedo.values() && a.fallen_mm == b.fallen_mm;
}

double mean(const FactorMap& map) {
  return std::accumulate(map.values().begin(), map.values().end(), 0.0) /
         static_cast<double>(map.values().size());
}

TEST(SnowGround, IsTheSameForAFrameAloneAndInSequence) {
  const SnowGround in_sequence(snowy_scene(), hillside(), changing);
  SnowGround::State last;
  for (int frame = 0; frame < 48; ++frame) last = in_sequence.at(1800.0 * frame);
  EXPECT_TRUE(same(last, SnowGround(snowy_scene(), hillside(), changing).at(1800.0 * 47)));
  const SnowGround alone(snowy_scene(), hillside(), changing);
  EXPECT_TRUE(same(in_sequence.at(1000.0), alone.at(1000.0)));  // and back in time
  EXPECT_FALSE(same(last, alone.at(1000.0)));
}

TEST(SnowGround, HoldsWhatFell) {
  scene::Scene scene = snowy_scene();
  const auto steady = [](double) { return WeatherMoment{-5.0, 2.0, 3.0, 75.0}; };
  const SnowGround ground(scene, hillside(), steady);
  const SnowGround::State state = ground.at(3.5 * 3600.0);
  EXPECT_NEAR(state.fallen_mm, 2.0 + 2.0 * 10.0, 1e-9);
  EXPECT_NEAR(mean(state.water_mm), 22.0, 1e-4);
  EXPECT_GT(std::ranges::max(state.water_mm.values()), 23.0);  // it drifts
  EXPECT_NEAR(mean(ground.at(-6.5 * 3600.0).water_mm), 2.0, 1e-6);
  scene.snow_cover.drifting = 0.0;
  const SnowGround still(scene, hillside(), steady);
  EXPECT_NEAR(std::ranges::min(still.at(3.5 * 3600.0).water_mm.values()), 22.0, 1e-4);
}

TEST(SnowGround, IsWhiteAboveTheSnowLineAndGrowsWhileItSnows) {
  scene::Scene scene = snowy_scene();
  scene.snow_cover.initial_mm = 0.0;
  scene.weather.earlier_h = 0.0;
  // 2 degrees at the foot, none 308 m higher: snow falls in the upper part alone
  const SnowGround ground(scene, hillside(), [](double) {
    return WeatherMoment{2.0, 1.0, 0.0, 0.0};
  });
  FactorMap before(301, 480.0);
  for (double hours : {0.0, 0.5, 1.0, 2.0, 4.0}) {
    const FactorMap white = ground.white(ground.at(3600.0 * hours), 301);
    for (std::size_t i = 0; i < white.values().size(); ++i)
      ASSERT_GE(white.values()[i], before.values()[i]);
    before = white;
  }
  EXPECT_GT(before.at(150, 295), 0.8F);
  EXPECT_LT(before.at(150, 5), 0.2F);
}

TEST(SnowGround, WhitensAsThePaperHasItWithoutDepth) {
  scene::Scene scene = snowy_scene();
  scene.snow_cover.cover = scene::CoverModel::paper;
  scene.snow_cover.white_after_mm = 16.0;
  const SnowGround ground(scene, hillside(), [](double) { return WeatherMoment{-9.0, 2.0}; });
  const SnowGround::State state = ground.at(-5.5 * 3600.0);  // 2 mm to start with and 2 mm more
  EXPECT_EQ(mean(state.depth_m), 0.0);
  EXPECT_NEAR(state.fallen_mm, 4.0, 1e-9);
  EXPECT_NEAR(mean(ground.white(state, 601)), 1.0 - std::exp(-1.0), 4e-3);
}

TEST(SnowGround, RefusesWhatIsNoNumber) {
  Heightfield terrain = hillside();
  terrain.at(7, 3) = std::nanf("");
  const auto calm = [](double) { return WeatherMoment{}; };
  try {
    SnowGround(snowy_scene(), terrain, calm);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("column 7 of row 3"));
  }
  const SnowGround ground(snowy_scene(), hillside(), [](double) {
    return WeatherMoment{std::nan(""), 1.0};
  });
  EXPECT_THROW(ground.at(10.0), InputError);
}

TEST(SnowGround, ToleratesATerrainOfOneCellAndNoCover) {
  scene::Scene scene = snowy_scene();
  const auto snow = [](double) { return WeatherMoment{-1.0, 1.0, 2.0, 10.0}; };
  const SnowGround small(scene, Heightfield(2, 30.0, 5.0F), snow);
  EXPECT_NEAR(mean(small.at(0.0).water_mm), 8.5, 1e-5);
  scene.snow_cover.cover = scene::CoverModel::none;
  const SnowGround none(scene, hillside(), snow);
  EXPECT_EQ(mean(none.at(3600.0).depth_m), 0.0);
  EXPECT_EQ(mean(none.white(none.at(3600.0), 33)), 0.0);
}

}  // namespace
}  // namespace wold::snow
