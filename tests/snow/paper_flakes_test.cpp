#include "snow/paper_flakes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace wold::snow {
namespace {

const FlakePictures& pictures() {
  static const FlakePictures made(1);
  return made;
}

scene::Scene paper_scene(scene::SnowfallStrength strength) {
  scene::Scene scene;
  scene.snowfall.motion = scene::Law::paper;
  scene.snowfall.strength = strength;
  scene.terrain.size_m = 200.0;
  return scene;
}

PaperSnow snow_of(const scene::Scene& scene) {
  return PaperSnow(scene, Weather(scene, nullptr), pictures());
}

const SnowView view = {
    .eye_m = {50.0, 50.0, 2.0}, .target_m = {50.0, 60.0, 3.0}, .width_px = 640, .height_px = 360};
const PaperBox box = {{42.0, 50.0, 0.0}, {16.0, 16.0, 10.0}};

TEST(PaperSnow, IsThePapersNumbersOfFlakes) {
  const Heightfield ground(2, 200.0, 0.0F);
  const auto seen = [&](const scene::Scene& scene) {
    return static_cast<double>(snow_of(scene).at(12.0, view, ground).flakes.size());
  };
  EXPECT_NEAR(seen(paper_scene(scene::SnowfallStrength::light)), 500.0, 125.0);
  EXPECT_NEAR(seen(paper_scene(scene::SnowfallStrength::moderate)), 1000.0, 250.0);
  EXPECT_NEAR(seen(paper_scene(scene::SnowfallStrength::blizzard)), 4000.0, 1000.0);
  scene::Scene asked = paper_scene(scene::SnowfallStrength::light);
  asked.snowfall.flakes = 3000;
  EXPECT_NEAR(seen(asked), 3000.0, 750.0);
}

/// S += V dt: small steps by the velocity lead from one place to the next.
TEST(PaperSnow, PlacesAreTheSumsOfVelocities) {
  const PaperSnow snow = snow_of(paper_scene(scene::SnowfallStrength::light));
  for (std::uint64_t i = 0; i < 50; ++i) {
    const double step_s = 0.01;
    PaperFlake flake = snow.flake(i, snow.moment(20.0), box);
    glm::dvec3 pos_m = flake.pos_m;
    for (int step = 0; step < 200; ++step) {
      const double time_s = 20.0 + (step + 0.5) * step_s;
      pos_m += step_s * snow.flake(i, snow.moment(time_s), box).velocity_m_s();
    }
    const PaperFlake then = snow.flake(i, snow.moment(22.0), box);
    if (then.start_assign != flake.start_assign) continue;  // born again meanwhile
    // As often round the sides as it may have been.
    for (int axis = 0; axis < 2; ++axis)
      EXPECT_NEAR(std::remainder(then.pos_m[axis] - pos_m[axis], box.size_m[axis]), 0.0, 0.01) << i;
    EXPECT_NEAR(then.pos_m.z, pos_m.z, 1e-6) << i;
  }
}

TEST(PaperSnow, IsBornAgainAtTheTopElsewhere) {
  const PaperSnow snow = snow_of(paper_scene(scene::SnowfallStrength::light));
  int births = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    PaperFlake before = snow.flake(i, snow.moment(0.0), box);
    for (double time_s = 0.02; time_s < 20.0; time_s += 0.02) {
      const PaperFlake now = snow.flake(i, snow.moment(time_s), box);
      if (now.start_assign != before.start_assign) {
        ++births;
        ASSERT_EQ(now.start_assign, before.start_assign + 1);
        ASSERT_LT(before.pos_m.z, 0.1);
        ASSERT_GT(now.pos_m.z, 9.9);
        ASSERT_GT(glm::distance(glm::dvec2(now.pos_m), glm::dvec2(before.pos_m)), 1e-3);
      }
      before = now;
    }
  }
  EXPECT_GT(births, 150);
}

/// But for its flutter and own gusts, which are no longer than a metre or so.
TEST(PaperSnow, StaysInTheBoxHoweverFastTheWind) {
  scene::Scene scene = paper_scene(scene::SnowfallStrength::blizzard);
  scene.wind.speed_m_s = 60.0;
  scene.wind.turbulence = 1.0;
  scene.weather.earlier_h = 1e4;
  const PaperSnow snow = snow_of(scene);
  const PaperSnow::Moment moment = snow.moment(1e5);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const glm::dvec3 in_box = snow.flake(i, moment, box).pos_m - box.low_m;
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_TRUE(in_box[axis] >= -1.2 && in_box[axis] <= box.size_m[axis] + 1.2);
  }
}

TEST(PaperSnow, StaysWhereItIsWhenTheBoxMoves) {
  const PaperSnow snow = snow_of(paper_scene(scene::SnowfallStrength::light));
  const PaperSnow::Moment moment = snow.moment(7.0);
  PaperBox moved = box;
  moved.low_m += glm::dvec3(1.0, -0.5, 0.5);
  int same = 0;
  for (std::uint64_t i = 0; i < 1000; ++i)
    same +=
        glm::distance(snow.flake(i, moment, box).pos_m, snow.flake(i, moment, moved).pos_m) < 1e-6
            ? 1
            : 0;
  // What is in both boxes: 15/16 x 15.5/16 x 9.5/10.
  EXPECT_NEAR(same, 863, 40);
}

TEST(PaperSnow, DensityFallsWithDistance) {
  scene::Scene scene = paper_scene(scene::SnowfallStrength::light);
  scene.snowfall.flakes = 40000;
  const Heightfield ground(2, 200.0, -1e6F);
  const Frustum frustum(view);
  double near_count = 0.0, far_count = 0.0;
  for (const SeenFlake& flake : snow_of(scene).at(3.0, view, ground).flakes) {
    const double distance_m = glm::distance(glm::dvec3(flake.centre_m), view.eye_m);
    if (distance_m < 4.0) near_count += 1.0;
    if (distance_m > 6.0 && distance_m < 8.0) far_count += 1.0;
  }
  // Shells of 64 and 296 m3 / 3 sr; exp(-r / 16) has the means 0.831 and 0.642 there.
  EXPECT_NEAR(far_count / near_count, 296.0 * 0.642 / (64.0 * 0.831), 0.2);
}

}  // namespace
}  // namespace wold::snow
