#include "scene/shots.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meadow/film_lights.h"
#include "place/nearby_frames.h"
#include "place/view.h"
#include "scene/calendar.h"
#include "support/film_parts.h"

/// What a film of shots shows: where the camera is, by which light, in which weather.
namespace wold::place {
namespace {

/// Three frames of an hour each from nine o'clock, and two of a noon, each with a camera of its
/// own.
scene::Scene film() {
  scene::Scene scene;
  scene.render.size_px = {160, 90};
  scene.terrain.size_m = 8.0;
  scene.terrain.samples = 33;
  scene.camera = {.eye_m = {4.0, 0.5}, .target_m = {4.0, 6.0}};
  scene.season.first = {2026, 9, 1};
  scene.season.last = {2026, 10, 1};
  scene.season_keys = {{.date = {2026, 9, 1}, .weathering = 0.0},
                       {.date = {2026, 10, 1}, .weathering = 1.0}};
  scene.film.frames_per_second = 1.0;
  scene.shots = {{.name = "flight",
                  .date = {2026, 9, 4},
                  .time_h = 9.0,
                  .seconds = 3.0,
                  .frame_seconds = 3600.0,
                  .camera = {.eye_m = {1.0, 2.0},
                             .eye_height_m = 2.0,
                             .target_m = {1.0, 6.0},
                             .target_height_m = 1.0,
                             .field_of_view_deg = 30.0,
                             .eye_end = {3.0, 4.0, 6.0}}},
                 {.name = "noon",
                  .date = {2026, 9, 16},
                  .time_h = 12.0,
                  .seconds = 2.0,
                  .frame_seconds = 0.04,
                  .camera = scene.camera}};
  return scene;
}

TEST(ShotsInPlace, HaveTheirCamerasOnTheirWays) {
  const scene::Scene scene = test::film_of(film());
  const Heightfield level(2, 8.0, 10.0F);
  const auto expect_eye = [&](int frame, const glm::dvec3& eye_m) {
    EXPECT_LT(glm::distance(camera_of_frame(scene, level, frame).eye_m, eye_m), 1e-12) << frame;
  };
  expect_eye(1, {1.0, 2.0, 12.0});
  expect_eye(2, {2.0, 3.0, 14.0});
  expect_eye(3, {3.0, 4.0, 16.0});
  expect_eye(4, {4.0, 0.5, 11.6});
  expect_eye(5, {4.0, 0.5, 11.6});
  EXPECT_EQ(camera_of_frame(scene, level, 2).field_of_view_deg, 30.0);
  EXPECT_EQ(camera_of_frame(scene, level, 4).field_of_view_deg, 55.0);
  EXPECT_NEAR(pixels_per_radian(scene),
              scene.render.size_px[0] / 2.0 / std::tan(glm::radians(15.0)), 1e-9);  // the longest
}

// Days pass evenly from degree 0 to 1; what is so on a day is so at its noon.
TEST(ShotsInPlace, WitherByTheirDay) {
  const scene::Scene scene = test::film_of(film());
  ASSERT_EQ(scene.ageing.frames.size(), 5u);
  EXPECT_EQ(scene.season.frames, 5);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(scene.ageing.frames[static_cast<std::size_t>(i)], (3.0 + (i - 3.0) / 24.0) / 30.0,
                1e-12);
  EXPECT_NEAR(scene.ageing.frames[3], 0.5, 1e-12);
}

TEST(ShotsInPlace, HaveTheWeatherOfTheirMoment) {
  scene::Scene scene = film();
  scene.season_keys[0].precipitation_mm_day = 0.0;
  scene.season_keys.insert(scene.season_keys.begin() + 1,
                           {.date = {2026, 9, 15}, .precipitation_mm_day = 0.0});
  scene.season_keys.insert(scene.season_keys.begin() + 2,
                           {.date = {2026, 9, 16}, .precipitation_mm_day = 24.0});
  scene = test::film_of(scene);
  const auto season = phenology::film_season(scene);
  const snow::Weather weather(scene, season.get());
  EXPECT_EQ(weather.at(scene::time_s(scene, 1)).precipitation_mm_h, 0.0);
  EXPECT_NEAR(weather.at(scene::time_s(scene, 4)).precipitation_mm_h, 1.0, 1e-9);
}

// Seven degrees above the equator the sun goes 30 cos(7) = 29.8 degrees in two hours, in three
// steps of 10 at most, and stands still for the fraction of a second; another shot of the same noon
// needs no light of its own.
TEST(ShotsInPlace, ShareTheLightsOfTheirTime) {
  scene::Scene scene = test::film_of(film());
  const int lights = meadow::light_count(scene);
  EXPECT_EQ(lights, 4 + 1);
  EXPECT_EQ(meadow::light_of_frame(scene, 1), 0.0);
  EXPECT_EQ(meadow::light_of_frame(scene, 3), 3.0);
  EXPECT_EQ(meadow::light_of_frame(scene, 4), 4.0);
  scene.shots.push_back(scene.shots[1]);
  scene.shots[2].camera.eye_m = {2.0, 1.0};
  EXPECT_EQ(meadow::light_count(scene), lights);
  EXPECT_EQ(meadow::light_of_frame(scene, 6), 4.0);
  const Site site = test::site_of(test::film_of(scene));
  const auto made = meadow::film_lights(scene, site);
  ASSERT_EQ(static_cast<int>(made.size()), lights);
  for (const auto& [frame, light] : {std::pair{1, 0}, std::pair{3, 3}, std::pair{4, 4}})
    EXPECT_LT(glm::distance(glm::dvec3(made[static_cast<std::size_t>(light)].sun_direction),
                            site_of_frame(scene, site, frame).day.sun_direction()),
              1e-5);  // half of 0.04 s
}

TEST(ShotsInPlace, MeanNothingAcrossACut) {
  const scene::Scene scene = test::film_of(film());
  EXPECT_EQ(mean_of_nearby(scene, 3, [](int frame) { return frame > 3 ? 100.0 : 1.0; }), 1.0);
  EXPECT_EQ(mean_of_nearby(scene, 4, [](int frame) { return frame < 4 ? 100.0 : 1.0; }), 1.0);
}

/// A season of 110 days.
scene::Scene season_of(int frames) {
  scene::Scene scene;
  scene.season.first = {2026, 9, 1};
  scene.season.last = {2026, 12, 20};
  scene.season.frames = frames;
  scene.ageing.frames.assign(static_cast<std::size_t>(frames), 0.0);
  return scene;
}

TEST(NearbyFrames, CountInAMeanWhenTheyAreOfTheSameWeek) {
  const auto mean = [](int frames) {
    return mean_of_nearby(season_of(frames), 3, [](int frame) { return frame == 3 ? 9.0 : 0.0; });
  };
  EXPECT_DOUBLE_EQ(mean(111), 3.0);             // a day apart: 3 of 1 + 2 + 3 + 2 + 1
  EXPECT_DOUBLE_EQ(mean(23), 9.0 * 3.0 / 7.0);  // five days apart
  EXPECT_DOUBLE_EQ(mean(5), 9.0);               // four weeks apart
}

TEST(NearbyFrames, AreMissingInASeasonOfAFewPictures) {
  EXPECT_TRUE(has_nearby_frames(season_of(111), 1));
  EXPECT_TRUE(has_nearby_frames(season_of(111), 111));
  EXPECT_FALSE(has_nearby_frames(season_of(5), 3));
  EXPECT_FALSE(has_nearby_frames(season_of(1), 1));
}

}  // namespace
}  // namespace wold::place
