#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "snow/flake_look.h"
#include "snow/flake_motion.h"
#include "snow/paper_flakes.h"

/// How single flakes look and move, against the paper's words and plain geometry.
namespace wold::snow {
namespace {

const FlakePictures& pictures() {
  static const FlakePictures made(1);
  return made;
}

/// From the origin to the north.
const SnowView view = {.eye_m = {0.0, 0.0, 0.0},
                       .target_m = {0.0, 10.0, 0.0},
                       .field_of_view_deg = 60.0,
                       .width_px = 1000,
                       .height_px = 500};

/// A metre at a distance of one covers so many pixels in the middle of the picture: the width of
/// the view is 2 tan(30 deg) there.
const double pixels_per_radian = 1000.0 / (2.0 * std::tan(std::numbers::pi / 6.0));

Flake still_flake(double distance_m, double diameter_m) {
  Flake flake;
  flake.centre_m = {0.0, distance_m, 0.0};
  flake.diameter_m = diameter_m;
  flake.crystal = Crystal::dendrite;
  return flake;
}

SeenFlake seen(const Flake& flake, double shutter_s = 0.0) {
  const Frustum frustum(view);
  const FlakeLook look(pictures(), frustum, shutter_s);
  FlakeLanes lanes_of_one = {};
  lanes_of_one.set(0, flake, view.eye_m);
  SeenFlake result;
  look.see(lanes_of_one, Chosen::by([](std::size_t) { return true; }, 1), &result);
  return result;
}

bool is_crystal(const SeenFlake& flake) {
  return flake.picture != pictures().disc() && flake.picture != pictures().streak();
}

// The paper, section 2: flakes are textured up to 3.5 m, white discs beyond.
TEST(FlakeLook, TexturesEndWhereThePaperHasIt) {
  EXPECT_TRUE(is_crystal(seen(still_flake(3.45, 0.01))));
  EXPECT_EQ(seen(still_flake(3.55, 0.01)).picture, pictures().disc());
}

// A picture has between one and two of its pixels in one of the view's, as far as there are finer
// and coarser ones: fewer are blurred, more alias.
TEST(FlakeLook, PicturesAreAsFineAsTheView) {
  std::vector<int> widths;
  for (const double diameter_m : {0.001, 0.002, 0.004, 0.008, 0.016})
    for (const double distance_m : {0.2, 0.4, 0.8, 1.6, 3.2}) {
      const SeenFlake flake = seen(still_flake(distance_m, diameter_m));
      ASSERT_TRUE(is_crystal(flake));
      const int width_px = pictures().all()[static_cast<std::size_t>(flake.picture)].opacity.width;
      const double seen_px =
          2.0 * static_cast<double>(glm::length(flake.right_m)) / distance_m * pixels_per_radian;
      const int coarsest_px = FlakePictures::finest_px >> (FlakePictures::levels - 1);
      if (width_px < FlakePictures::finest_px) {
        EXPECT_GE(width_px, 0.999 * seen_px);
      }
      if (width_px > coarsest_px) {
        EXPECT_LT(width_px, 2.001 * seen_px);
      }
      widths.push_back(width_px);
    }
  std::sort(widths.begin(), widths.end());
  widths.erase(std::unique(widths.begin(), widths.end()), widths.end());
  EXPECT_EQ(widths.size(), static_cast<std::size_t>(FlakePictures::levels));
}

// However far a flake is, it covers a pixel or more: smaller ones would come and go from frame to
// frame.
TEST(FlakeLook, FlakesAreAsWideAsAPixel) {
  for (const double distance_m : {4.0, 10.0, 40.0, 160.0}) {
    const SeenFlake flake = seen(still_flake(distance_m, 0.002));
    const double pixel_m = distance_m / pixels_per_radian;
    EXPECT_GE(2.0 * static_cast<double>(glm::length(flake.right_m)), 0.999 * pixel_m);
    EXPECT_GE(2.0 * static_cast<double>(glm::length(flake.up_m)), 0.999 * pixel_m);
  }
}

// A disc of diameter D that moves by v t covers v t + D along its way and D across it.
TEST(FlakeLook, StreaksAreTheWayAndTheFlake) {
  Flake flake = still_flake(2.0, 0.01);
  flake.velocity_m_s = {3.0, 5.0, 4.0};  // what goes away from the eye is not seen
  const SeenFlake streak = seen(flake, 0.01);
  ASSERT_EQ(streak.picture, pictures().streak());
  EXPECT_NEAR(2.0 * static_cast<double>(glm::length(streak.up_m)), 0.05 + 0.01, 1e-5);
  EXPECT_NEAR(2.0 * static_cast<double>(glm::length(streak.right_m)), 0.01, 1e-5);
  const glm::vec3 along = glm::normalize(streak.up_m);
  EXPECT_NEAR(std::abs(glm::dot(along, glm::vec3(0.6F, 0.0F, 0.8F))), 1.0F, 1e-4F);
}

/// Flakes of one place and time.
FlakeLanes flakes_at(double time_s, std::uint64_t first, const scene::Scene& scene) {
  const FlakeMotion motion(scene, Weather(scene, nullptr), 1.0);
  const FlakeMotion::Moment moment = motion.moment(time_s, 1.0);
  const FlakeMotion::Air air =
      FlakeMotion::air(Population(3, 100000), {{0.0, 0.0, 0.0}, 30.0}, moment, glm::dvec3(0.0));
  FlakeMotion::Drifting drifting;
  FlakeLanes flying;
  motion.drift(air, first, drifting);
  motion.fly(drifting, moment, flying);
  return flying;
}

scene::Scene snowy() {
  scene::Scene scene;
  scene.weather.temperature_c = -5.0;
  scene.weather.precipitation_mm_h = 1.0;
  return scene;
}

// Li 2024: falling flakes tumble at 0.5 to 2.5 turns a second. They turn at up to half of that
// about the way to the eye, to either side.
TEST(FlakeMotion, FlakesTumbleAndTurnAsMeasured) {
  const double step_s = 0.01;
  int to_the_left = 0, flakes = 0;
  double slowest = 1e9, fastest = 0.0;
  for (std::uint64_t first = 0; first < 16 * lanes; first += lanes) {
    const FlakeLanes before = flakes_at(50.0, first, snowy());
    const FlakeLanes after = flakes_at(50.0 + step_s, first, snowy());
    for (std::size_t i = 0; i < lanes; ++i, ++flakes) {
      const auto rate = [&](float from, float to) {
        return std::remainder(static_cast<double>(to) - static_cast<double>(from), 1.0) / step_s;
      };
      const double tumbles = rate(before.tilt_turns[i], after.tilt_turns[i]);
      const double turns = rate(before.spin_turns[i], after.spin_turns[i]);
      slowest = std::min(slowest, tumbles);
      fastest = std::max(fastest, tumbles);
      ASSERT_LT(std::abs(turns), 1.25 + 0.01);
      to_the_left += turns < 0.0 ? 1 : 0;
    }
  }
  EXPECT_NEAR(slowest, 0.5, 0.05);
  EXPECT_NEAR(fastest, 2.5, 0.05);
  EXPECT_NEAR(static_cast<double>(to_the_left) / flakes, 0.5, 0.06);
}

// The picture of a near flake turns by what the flake does.
TEST(FlakeLook, PicturesTurnWithTheFlake) {
  Flake flake = still_flake(1.0, 0.01);
  const auto angle_turns = [&](float spin_turns) {
    flake.spin_turns = spin_turns;
    const glm::vec3 right = glm::normalize(seen(flake).right_m);
    return std::atan2(static_cast<double>(right.z), static_cast<double>(right.x)) /
           (2.0 * std::numbers::pi);
  };
  const double start = angle_turns(0.0F);
  for (const float spin_turns : {0.1F, 0.2F, 0.4F})
    EXPECT_NEAR(std::abs(std::remainder(angle_turns(spin_turns) - start, 1.0)), spin_turns, 1e-4);
}

// What flakes at the same time have of their own is a quarter of the wind's variance, along each
// level axis; upwards a quarter of that.
TEST(FlakeMotion, FlakesAreInGustsOfTheirOwn) {
  scene::Scene scene = snowy();
  scene.wind.field = scene::WindPattern::gusts;
  scene.wind.speed_m_s = 20.0;
  scene.wind.turbulence = 0.3;
  glm::dvec3 sum(0.0), squares(0.0);
  double count = 0.0;
  for (std::uint64_t first = 0; first < 64 * lanes; first += lanes) {
    const FlakeLanes flakes = flakes_at(50.0, first, scene);
    for (std::size_t i = 0; i < lanes; ++i) {
      const glm::dvec3 velocity_m_s(flakes.velocity.at(i));
      sum += velocity_m_s;
      squares += velocity_m_s * velocity_m_s;
      count += 1.0;
    }
  }
  const glm::dvec3 deviation_m_s = glm::sqrt(squares / count - (sum / count) * (sum / count));
  const double own_m_s = 0.5 * 0.3 * 20.0;
  EXPECT_NEAR(deviation_m_s.x, own_m_s, 0.08 * own_m_s);
  EXPECT_NEAR(deviation_m_s.y, own_m_s, 0.08 * own_m_s);
  EXPECT_NEAR(deviation_m_s.z, 0.5 * own_m_s, 0.08 * own_m_s);
}

// The paper's flakes turn by their own rot, rot = random, which is the rate of their angle for
// good.
TEST(PaperSnow, FlakesTurnByTheirOwnRates) {
  scene::Scene scene = snowy();
  scene.snowfall.motion = scene::Law::paper;
  const PaperSnow snow(scene, Weather(scene, nullptr), pictures());
  const PaperBox box = {{-8.0, 0.0, 0.0}, {16.0, 16.0, 10.0}};
  const double step_s = 0.25;
  double slowest_per_s = 0.0, fastest_per_s = 0.0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const PaperFlake before = snow.flake(i, snow.moment(20.0), box);
    const PaperFlake after = snow.flake(i, snow.moment(20.0 + step_s), box);
    const double turned = std::remainder(after.angle_turns - before.angle_turns, 1.0);
    ASSERT_NEAR(turned, step_s * before.rot_per_s, 1e-9);
    slowest_per_s = std::min(slowest_per_s, turned / step_s);
    fastest_per_s = std::max(fastest_per_s, turned / step_s);
  }
  EXPECT_LT(slowest_per_s, -0.4);
  EXPECT_GT(fastest_per_s, 0.4);
}

}  // namespace
}  // namespace wold::snow
