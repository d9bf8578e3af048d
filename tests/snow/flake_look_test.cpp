#include "snow/flake_look.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "snow/falling_snow.h"
#include "snow/paper_flakes.h"

/// How flakes turn and how finely they are drawn, as a view sees them.
namespace wold::snow {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
/// The paper's, beyond which flakes are white and do not turn.
constexpr double papers_limit_m = 3.5;

const FlakePictures& pictures() {
  static const FlakePictures made(1);
  return made;
}

const SnowView view = {
    .eye_m = {21.0, 2.0, 1.6}, .target_m = {24.0, 20.0, 1.6}, .width_px = 640, .height_px = 360};

const Heightfield& no_ground() {
  static const Heightfield ground(2, 42.0, -1e6F);
  return ground;
}

scene::Scene still_snow(scene::Law motion) {
  scene::Scene scene;
  scene.weather.temperature_c = -5.0;
  scene.weather.precipitation_mm_h = 4.0;
  scene.wind.field = scene::WindPattern::steady;
  scene.wind.speed_m_s = 0.1;
  scene.snowfall.motion = motion;
  scene.snowfall.shutter_s = 0.0;
  return scene;
}

std::vector<SeenFlake> seen_at(scene::Law motion, double time_s, const SnowView& from = view) {
  const scene::Scene scene = still_snow(motion);
  if (motion == scene::Law::paper)
    return PaperSnow(scene, Weather(scene, nullptr), pictures())
        .at(time_s, from, no_ground())
        .flakes;
  return FallingSnow(scene, Weather(scene, nullptr), pictures())
      .at(time_s, from, no_ground())
      .flakes;
}

bool is_crystal(const SeenFlake& flake) {
  return flake.picture != pictures().disc() && flake.picture != pictures().streak();
}

double distance_m(const SeenFlake& flake) {
  return glm::distance(glm::dvec3(flake.centre_m), view.eye_m);
}

/// The flake of a picture taken a moment later that is the same one: as large, and nearest.
const SeenFlake* same_flake(const SeenFlake& flake, const std::vector<SeenFlake>& later) {
  const SeenFlake* nearest = nullptr;
  float nearest_m = 0.01F;
  for (const SeenFlake& other : later) {
    const float away_m = glm::distance(flake.centre_m, other.centre_m);
    if (away_m >= nearest_m || other.picture != flake.picture) continue;
    nearest = &other;
    nearest_m = away_m;
  }
  return nearest;
}

/// Mean turns a second about the way to the eye, of crystals as they are seen.
double mean_spin_per_s(scene::Law motion, double time_s) {
  constexpr double step_s = 2e-3;
  const std::vector<SeenFlake> now = seen_at(motion, time_s);
  const std::vector<SeenFlake> later = seen_at(motion, time_s + step_s);
  double turns = 0.0;
  int compared = 0;
  for (const SeenFlake& flake : now) {
    if (!is_crystal(flake)) continue;
    const SeenFlake* same = same_flake(flake, later);
    if (same == nullptr) continue;
    const glm::dvec3 before = glm::normalize(glm::dvec3(flake.right_m));
    const glm::dvec3 after = glm::normalize(glm::dvec3(same->right_m));
    turns += std::atan2(glm::length(glm::cross(before, after)), glm::dot(before, after)) / two_pi;
    ++compared;
  }
  EXPECT_GT(compared, 20) << scene::word_of(motion);
  return turns / compared / step_s;
}

/// Spins are spread evenly: physical ones up to 1.25 turns a second either way, the paper's up to
/// half of one. Their means are half of that.
TEST(FlakeLook, NearFlakesTurn) {
  double physical = 0.0, paper = 0.0;
  for (const double time_s : {10.0, 30.0, 50.0, 70.0}) {
    physical += mean_spin_per_s(scene::Law::physical, time_s) / 4.0;
    paper += mean_spin_per_s(scene::Law::paper, time_s) / 4.0;
  }
  EXPECT_NEAR(physical, 0.625, 0.07);
  EXPECT_NEAR(paper, 0.25, 0.04);
}

/// Physical flakes tumble, to 60 degrees off facing the eye; the paper's stay rectangles across the
/// way to it.
TEST(FlakeLook, PhysicalFlakesTumbleAndThePapersFaceTheEye) {
  for (const scene::Law motion : {scene::Law::physical, scene::Law::paper}) {
    double max_deg = 0.0;
    for (const SeenFlake& flake : seen_at(motion, 10.0)) {
      if (!is_crystal(flake)) continue;
      const glm::dvec3 face =
          glm::normalize(glm::cross(glm::dvec3(flake.right_m), glm::dvec3(flake.up_m)));
      const glm::dvec3 to_eye = glm::normalize(view.eye_m - glm::dvec3(flake.centre_m));
      const double cosine = std::min(1.0, std::abs(glm::dot(face, to_eye)));
      max_deg = std::max(max_deg, glm::degrees(std::acos(cosine)));
    }
    if (motion == scene::Law::paper)
      EXPECT_LT(max_deg, 0.1);
    else
      EXPECT_NEAR(max_deg, 60.0, 1.5);
  }
}

TEST(FlakeLook, BeyondThePapersLimitFlakesAreDiscsThatDoNotTurn) {
  for (const scene::Law motion : {scene::Law::physical, scene::Law::paper}) {
    double farthest_crystal_m = 0.0, nearest_disc_m = 1e9;
    for (const SeenFlake& flake : seen_at(motion, 10.0)) {
      if (is_crystal(flake)) {
        farthest_crystal_m = std::max(farthest_crystal_m, distance_m(flake));
        continue;
      }
      nearest_disc_m = std::min(nearest_disc_m, distance_m(flake));
      ASSERT_NEAR(flake.right_m.z, 0.0F, 1e-6F) << "a disc's right side is level";
    }
    EXPECT_NEAR(farthest_crystal_m, papers_limit_m, 0.2) << scene::word_of(motion);
    EXPECT_NEAR(nearest_disc_m, papers_limit_m, 0.2) << scene::word_of(motion);
  }
}

/// Figure 2: the larger a flake is in the picture, the finer its texture: the coarsest of 128, 64,
/// 32 and 16 pixels whose pixels are no larger than the picture's own.
TEST(FlakeLook, TexturesAreAsFineAsFlakesAreLarge) {
  for (const scene::Law motion : {scene::Law::physical, scene::Law::paper}) {
    std::map<int, int> flakes_of_px;
    for (const int width_px : {160, 640, 2560}) {
      SnowView of_size = view;
      of_size.width_px = width_px;
      of_size.height_px = width_px * 9 / 16;
      const double pixel_rad = Frustum(of_size).pixel_angle();
      for (const SeenFlake& flake : seen_at(motion, 10.0, of_size)) {
        if (!is_crystal(flake)) continue;
        const int texture_px =
            pictures().all()[static_cast<std::size_t>(flake.picture)].opacity.width;
        const double side_px =
            2.0 * static_cast<double>(glm::length(flake.right_m)) / (distance_m(flake) * pixel_rad);
        ASSERT_TRUE(texture_px == 128 || texture_px > 0.999 * side_px) << side_px;
        ASSERT_TRUE(texture_px == 16 || texture_px < 2.001 * side_px) << side_px;
        ++flakes_of_px[texture_px];
      }
    }
    std::set<int> used;
    for (const auto& [texture_px, flakes] : flakes_of_px) used.insert(texture_px);
    EXPECT_EQ(used, (std::set<int>{16, 32, 64, 128})) << scene::word_of(motion);
  }
}

/// Drawn as if the flake faced the eye, a quarter turn puts its right side where its upper one was.
TEST(FlakeLook, SpinTurnsTheRectangle) {
  const Frustum frustum(view);
  const FlakeLook look(pictures(), frustum, 0.0);
  const auto seen = [&](float spin_turns, float tilt_turns) {
    Flake flake;
    flake.centre_m = view.eye_m + 1.2 * glm::normalize(view.target_m - view.eye_m);
    flake.diameter_m = 0.006;
    flake.crystal = Crystal::dendrite;
    flake.spin_turns = spin_turns;
    flake.tilt_turns = tilt_turns;
    FlakeLanes flakes = {};
    flakes.set(0, flake, view.eye_m);
    const Chosen first = Chosen::by([](std::size_t) { return true; }, 1);
    SeenFlake result;
    look.see(flakes, first, &result);
    return result;
  };
  const SeenFlake still = seen(0.0F, 0.0F), turned = seen(0.25F, 0.0F), tilted = seen(0.0F, 0.25F);
  const float half_m = glm::length(still.right_m);
  EXPECT_NEAR(glm::distance(turned.right_m, still.up_m), 0.0F, 1e-5F * half_m + 1e-8F);
  EXPECT_NEAR(glm::distance(turned.up_m, -still.right_m), 0.0F, 1e-5F * half_m + 1e-8F);
  // Sixty degrees to one side: half as high as it was, seen from the eye.
  EXPECT_NEAR(glm::dot(tilted.up_m, still.up_m) / (half_m * half_m), 0.5F, 1e-4F);
}

}  // namespace
}  // namespace wold::snow
