#include "scene/shots.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

#include "problems.h"
#include "scene/calendar.h"
#include "scene/key_frames.h"
#include "scene/sun_path.h"
#include "scene/write.h"

namespace wold::scene {
namespace {

constexpr double day_s = 86400.0;

const std::string season =
    "[season]\nfirst = [2026, 9, 1]\nlast = [2026, 11, 30]\n"
    "[[season_keys]]\ndate = [2026, 9, 1]\nweathering = 0.5\n";

/// Four frames of live wind on an autumn morning, three of a time lapse that begins at sun.time.
const std::string two_shots =
    season +
    "[sun]\ntime = 9.5\n"
    "[camera]\neye = [10, 4]\nfield_of_view = 40\n"
    "[film]\nframe_seconds = 3600\nframes_per_second = 8\n"
    "[[shots]]\nname = \"gusts\"\ndate = [2026, 10, 3]\ntime = 13.25\n"
    "seconds = 0.5\nframe_seconds = 0.125\neye_end = [12, 4, 2]\n"
    "[[shots]]\ndate = [2026, 9, 20]\nseconds = 0.4\nfield_of_view = 70\n";

TEST(Shots, HaveTheirFramesOneAfterTheOther) {
  const Scene scene = parse_scene(two_shots, "a.toml");
  ASSERT_EQ(frame_count(scene), 7);  // 0.4 s are 3.2 frames
  const std::vector<Take> takes = {{1, 4}, {5, 3}};
  EXPECT_EQ(takes_of(scene), takes);
  for (const int frame : {1, 4}) EXPECT_EQ(take_of(scene, frame), takes[0]);
  for (const int frame : {5, 7}) EXPECT_EQ(take_of(scene, frame), takes[1]);
  EXPECT_EQ(shot_of(scene, 4)->name, "gusts");
  EXPECT_EQ(shot_of(scene, 5)->name, "shot_2");
  EXPECT_DOUBLE_EQ(way_of_frame(scene, 2), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(way_of_frame(scene, 4), 1.0);
  EXPECT_DOUBLE_EQ(way_of_frame(scene, 5), 0.0);
  EXPECT_DOUBLE_EQ(way_of_frame(scene, 6), 0.5);
}

TEST(Shots, OfPointsAreNotBlurred) {
  expect_problem("[film]\nshutter = 0.5\n[render]\ngrass = \"points\"\n",
                 "a.toml:2:1: film.shutter: found 0.5, expected 0 with render.grass = \"points\"");
}

// As camera.target_height does.
TEST(Shots, MayLookAtTheGroundInTheEnd) {
  const Scene scene =
      parse_scene("[camera]\neye_end = [12, 4, 2]\ntarget_end = [12, 9, 0]\n", "a.toml");
  EXPECT_EQ(scene.camera.target_end, std::vector<double>({12, 9, 0}));
}

TEST(Shots, AFilmWithoutThemIsOneTake) {
  Scene scene;
  scene.ageing.frames = {0.0, 0.5, 1.0};
  EXPECT_EQ(takes_of(scene), std::vector<Take>({{1, 3}}));
  EXPECT_EQ(shot_of(scene, 2), nullptr);
  EXPECT_EQ(way_of_frame(scene, 2), 0.5);
  EXPECT_EQ(&camera_of(scene, 2), &scene.camera);
}

// September has 30 days: 3 October is day 32 after 1 September, 20 September day 19.
TEST(Shots, OfASeasonAreOnTheClockOfTheWorld) {
  const Scene scene = parse_scene(two_shots, "a.toml");
  for (int i = 0; i < 4; ++i)
    EXPECT_DOUBLE_EQ(time_s(scene, 1 + i), 32 * day_s + 13.25 * 3600 + 0.125 * i);
  for (int i = 0; i < 3; ++i)
    EXPECT_DOUBLE_EQ(time_s(scene, 5 + i), 19 * day_s + 9.5 * 3600 + 3600.0 * i);
  for (const int frame : {1, 4, 5}) EXPECT_EQ(cloud_time_s(scene, frame), time_s(scene, frame));
  EXPECT_EQ(film_s(scene), time_s(scene, 4));
  EXPECT_EQ(clock_begins_h(scene), 0.0);
  EXPECT_DOUBLE_EQ(season_days(scene, 1), 32 + (13.25 - 12.0) / 24.0);  // a day is so at noon
  EXPECT_EQ(cloud_season_s(scene), 90 * day_s);
}

// In an hour clouds jump: frames that are so far apart are film.frame_seconds apart for them.
TEST(Shots, OfHoursLetCloudsDriftSlowly) {
  const auto scene_with = [](const std::string& seconds) {
    return parse_scene(
        two_shots, "a.toml",
        std::vector<std::string>{"shots[2].frame_seconds=" + seconds, "film.frame_seconds=4"});
  };
  const Scene lapse = scene_with("3600"), fast = scene_with("3599");
  EXPECT_TRUE(is_time_lapse(lapse, 7));
  EXPECT_FALSE(is_time_lapse(lapse, 4));
  EXPECT_EQ(cloud_time_s(lapse, 7), time_s(lapse, 5) + 8.0);
  EXPECT_EQ(cloud_time_s(fast, 7), time_s(fast, 7));
}

TEST(Shots, HaveTheSunOfTheirMoment) {
  using namespace std::chrono;
  const Scene scene = parse_scene(two_shots, "a.toml");
  const auto expect_sun = [&](int frame, year_month_day day, double hour) {
    const SunPosition want =
        sun_position(day, hour, scene.sun.latitude_deg, scene.sun.longitude_deg);
    const SunPosition got = sun_position(sun_of_frame(scene, frame));
    EXPECT_NEAR(got.elevation_deg, want.elevation_deg, 1e-9);
    EXPECT_NEAR(got.azimuth_deg, want.azimuth_deg, 1e-9);
  };
  expect_sun(1, 2026y / October / 3, 13.25);
  expect_sun(5, 2026y / September / 20, 9.5);
  expect_sun(7, 2026y / September / 20, 11.5);
  // Between two frames it stands between their suns.
  const Take lapse = take_of(scene, 5);
  EXPECT_EQ(sun_on_way(scene, lapse, 1.0).elevation_deg, sun_of_frame(scene, 7).elevation_deg);
  EXPECT_NEAR(sun_on_way(scene, lapse, 0.25).elevation_deg,
              0.5 * (sun_of_frame(scene, 5).elevation_deg + sun_of_frame(scene, 6).elevation_deg),
              1e-9);
}

// A frame a day: it is never night in it.
TEST(Shots, MayPassNights) {
  const Scene scene =
      parse_scene(two_shots, "a.toml", std::vector<std::string>{"shots[2].frame_seconds=86400"});
  for (double way = 0.0; way <= 1.0; way += 0.125)
    EXPECT_GT(sun_on_way(scene, take_of(scene, 5), way).elevation_deg, 20.0) << way;
}

TEST(Shots, WithoutASeasonStartOnTheScenesClock) {
  const Scene scene = parse_scene(
      "[film]\nframes_per_second = 4\n[sun]\nelevation = 30\nazimuth = 100\nend = [10, 160]\n"
      "[[shots]]\nstart = 60\nseconds = 0.5\nframe_seconds = 20\nweathering = [0.2, 0.6]\n"
      "[[shots]]\nstart = 20\nseconds = 0.75\nframe_seconds = 0.25\nweathering = [0.9]\n",
      "a.toml");
  EXPECT_EQ(time_s(scene, 2), 80.0);
  EXPECT_EQ(time_s(scene, 3), 20.0);
  EXPECT_EQ(time_s(scene, 5), 20.5);
  EXPECT_EQ(weathering_of_shots(scene), std::vector<double>({0.2, 0.6, 0.9, 0.9, 0.9}));
  EXPECT_EQ(sun_of_frame(scene, 3).elevation_deg, 30.0);  // the earliest moment
  EXPECT_EQ(sun_of_frame(scene, 2).elevation_deg, 10.0);  // the latest
  EXPECT_DOUBLE_EQ(sun_of_frame(scene, 1).azimuth_deg, 100.0 + 60.0 * 40.0 / 60.0);
}

TEST(Shots, TakeTheirCameraAndRateFromTheSceneAsFarAsTheySayNothing) {
  const Scene scene = parse_scene(two_shots, "a.toml");
  const Camera& first = scene.shots[0].camera;
  EXPECT_EQ(first.eye_m, scene.camera.eye_m);
  EXPECT_EQ(first.field_of_view_deg, 40.0);
  EXPECT_EQ(first.eye_end, std::vector<double>({12, 4, 2}));
  EXPECT_TRUE(camera_of(scene, 5).eye_end.empty());
  EXPECT_EQ(camera_of(scene, 7).field_of_view_deg, 70.0);
  EXPECT_EQ(scene.shots[1].frame_seconds, 3600.0);
  EXPECT_EQ(scene.shots[0].frame_seconds, 0.125);
}

// Seconds of weather change degrees by a millionth, and a cut by as much as it likes: neither makes
// more patches.
TEST(Shots, OfSecondsNeedNoMoreKeyFrames) {
  Scene scene = parse_scene(two_shots, "a.toml");
  scene.ageing.frames = {0.5, 0.500001, 0.500002, 0.500003, 0.40, 0.41, 0.42};
  EXPECT_EQ(key_frames(scene).size(), 13u);  // the lapse as a whole is shorter than a step, too
  scene.ageing.frames = {0.5, 0.500001, 0.500002, 0.500003, 0.40, 0.44, 0.48};
  EXPECT_EQ(key_frames(scene).size(), 26u);
}

TEST(Shots, AreReadAsTheyAreWritten) {
  const std::string plain =
      "[[shots]]\nseconds = 0.125\nweathering = [0.25, 0.75]\n[[shots]]\nstart = 7\n";
  for (const std::string& text : {two_shots, plain}) {
    const Scene scene = parse_scene(text, "a.toml");
    EXPECT_EQ(static_cast<int>(scene.ageing.frames.size()), frame_count(scene));
    EXPECT_EQ(scene.season.frames, frame_count(scene));
    EXPECT_EQ(parse_scene(resolved_toml(scene), "b.toml"), scene);
  }
}

TEST(Shots, SayWhatContradictsThem) {
  EXPECT_TRUE(problems_of(two_shots).empty());
  const auto expect = [](const std::string& set, const std::string& start) {
    expect_problem(two_shots, "--set " + set + ": " + start, {set});
  };
  expect("shots[2].name=gusts", "shots[2].name: found \"gusts\", which shots[1] has; expected a");
  expect("shots[1].date=[2026,12,3]",
         "shots[1].date: found [2026, 12, 3], expected a day of the season, from [2026, 9, 1] to");
  expect("shots[1].date=[2026,9,31]", "shots[1].date: found [2026, 9, 31], expected a year, month");
  expect("shots[1].time=23",
         "shots[1].time: found 23 h of universal time, by which the sun stands");
  expect_problem(two_shots, "a.toml:22:1: shots[2].time: found 9.5 h of universal time, by which",
                 {"shots[2].frame_seconds=1e6"});  // at night, 11 days later
  expect_problem(
      two_shots,
      "a.toml:22:1: shots[2].frame_seconds: found 3600 s, by which its 4800 frames last "
      "200.0 days; expected at most 71.6 days, to the end of season.last ([2026, 11, 30])",
      {"shots[2].seconds=600"});
  expect("shots[2].seconds=3000", "shots[2].seconds: found 3000 s, by which the film has 24004");
  expect("shots[1].start=5", "shots[1].start: found beside a season; expected date and time");
  expect("shots[1].weathering=[0.5]", "shots[1].weathering: found beside a season, whose days");
  expect("shots[1].eye=[1000,2]", "shots[1].eye: found [1000, 2] m, expected a place inside the");
  expect("shots[1].eye_end=[1,2]", "shots[1].eye_end: found a list of 2, expected three");
  expect("shots[1].eye_end=[1,2,0]",
         "shots[1].eye_end: found [1, 2, 0] m, expected a place inside the terrain, from 0 to");
  expect("ageing.frames=[0.5,0.6]",
         "ageing.frames: found 2 degrees beside [[shots]], which have 7 frames of their own");
  expect("season.frames=30", "season.frames: found 30 beside [[shots]], which have 7 frames");
  expect_problem("[[shots]]\nname = \"a\"\ndate = [2026, 9, 1]\n",
                 "a.toml:3:1: shots[1].date: found a day, but the scene is no season; expected "
                 "start, or season.first");
  expect_problem("[[shots]]\ntime = 5\n", "a.toml:2:1: shots[1].time: found an hour of the day");
  expect_problem("[ageing]\nframes = [0.2]\n[[shots]]\nseconds = 0.05\nweathering = [0.3]\n",
                 "a.toml:2:1: ageing.frames: found 1 degrees beside [[shots]], which have 1");
  expect_problem("[camera]\neye = [5, 5]\n[[shots]]\ntarget = [5, 5]\n",
                 "a.toml:4:1: shots[1].target: found [5, 5] m, expected another place than");
}

}  // namespace
}  // namespace wold::scene
