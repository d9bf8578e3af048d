#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "scene/parse.h"
#include "scene/problems.h"
#include "scene/write.h"

namespace wold::scene {
namespace {

TEST(CloudScene, ReadsLayersAndEventsInTheirOrder) {
  const Scene scene = parse_scene(
      "[[clouds]]\nkind = 'cirrus'\nbase = 8000\ncover = 'auto'\n"
      "[[cloud_events]]\nkind = 'gather'\nlayer = 2\nstart = 10\nfraction = 0.5\n"
      "[[clouds]]\ncells = [3, 4]\ncover = 0.25\n[film]\nframe_seconds = 5\n",
      "a.toml");
  Scene expected;
  expected.film.frame_seconds = 5.0;
  expected.clouds.resize(2);
  expected.clouds[0].kind = CloudKind::cirrus;
  expected.clouds[0].base_m = 8000.0;
  expected.clouds[1].cells = {3, 4};
  expected.clouds[1].cover = 0.25;
  expected.cloud_events = {
      {.kind = CloudEventKind::gather, .layer = 2, .start_s = 10.0, .fraction = 0.5}};
  EXPECT_EQ(scene, expected);
  EXPECT_EQ(parse_scene("clouds = [{kind = 'cirrus', base = 8000}]\n", "a.toml").clouds[0],
            expected.clouds[0]);
  EXPECT_EQ(parse_scene("clouds = []\n", "a.toml"), Scene{});
}

TEST(CloudScene, AnEmptySkyWritesNoLayers) {
  EXPECT_EQ(resolved_toml(Scene{}).find("[[cloud"), std::string::npos);
}

TEST(CloudScene, NamesItemLineAndColumn) {
  expect_problem("[[clouds]]\n[[clouds]]\n  speed = -1\n",
                 "a.toml:3:11: clouds[2].speed: found -1 m/s, expected a number from 0 to 100 m/s");
  expect_problem("[[clouds]]\ncover = 'all'\n",
                 "a.toml:2:9: clouds[1].cover: found \"all\", expected a number from 0 to 1, or "
                 "\"auto\"");
  expect_problem("[[clouds]]\ncover = 1.5\n", "a.toml:2:9: clouds[1].cover: found 1.5, expected");
  expect_problem("[[clouds]]\ncells = [0, 4]\n",
                 "a.toml:2:10: clouds[1].cells: found 0 (item 1), expected 2 whole numbers from 1");
  expect_problem("[[clouds]]\n[[cloud_events]]\nduration = 0\n",
                 "a.toml:3:12: cloud_events[1].duration: found 0 s, expected a number from 0.001");
  expect_problem("[[clouds]]\n[[cloud_events]]\nduration = -3\n",
                 "a.toml:3:12: cloud_events[1].duration: found -3 s, expected a number");
  expect_problem(
      "[[clouds]]\ntextures = ['']\n",
      "a.toml:2:13: clouds[1].textures: found \"\" (item 1), expected a list of 0 to 16");
}

TEST(CloudScene, SuggestsTheNearestKnownName) {
  expect_problem("[[clouds]]\nheight = 3\n", "a.toml:2:1: unknown key \"clouds[1].height\"");
  expect_problem("[[clouds]]\nopacty = 3\n",
                 "a.toml:2:1: unknown key \"clouds[1].opacty\"; did you mean "
                 "\"clouds[1].opacity\"?");
  expect_problem("[cluods]\n", "a.toml:1:2: unknown table [cluods]; did you mean \"clouds\"?");
  expect_problem(
      "[clouds]\nkind = 'cirrus'\n",
      "a.toml:1:2: clouds: found the table [clouds], expected [[clouds]], once for each");
  expect_problem("clouds = 3\n", "a.toml:1:1: clouds: found 3, expected tables [[clouds]], one");
  expect_problem("clouds = [3]\n", "a.toml:1:1: clouds: found a list of 1, expected tables");
  std::string many;
  for (int i = 0; i < 18; ++i) many += "[[clouds]]\n";
  expect_problem(many, "a.toml:17:1: clouds: found 17 [[clouds]], expected at most 16");
}

TEST(CloudScene, OverridesReachEveryItem) {
  const std::vector<std::string> overrides = {"clouds[2].cover=0.75", "clouds[1].base=auto"};
  const Scene scene = parse_scene("[[clouds]]\nbase = 900\n[[clouds]]\n", "a.toml", overrides);
  EXPECT_EQ(scene.clouds[0].base_m, std::nullopt);
  EXPECT_EQ(scene.clouds[1].cover, 0.75);
  expect_problem("[[clouds]]\n",
                 "--set clouds[2].cover=1: clouds[2].cover: there is no such layer of clouds; the "
                 "scene has 1 of them, counted from clouds[1]",
                 {"clouds[2].cover=1"});
  expect_problem("",
                 "--set clouds.cover=1: clouds.cover: there is no such layer of clouds; the scene "
                 "has none, a table [[clouds]] in it adds one",
                 {"clouds.cover=1"});
}

TEST(CloudEvents, ThatContradictEachOtherNameBothLines) {
  const std::string wind = "[[clouds]]\n[[cloud_events]]\nkind = 'wind'\nstart = 0\n";
  expect_problem(wind + "duration = 90\n[[cloud_events]]\nkind = 'slower'\nlayer = 1\nstart = 60\n",
                 "a.toml:9:1: cloud_events[2].start: found \"slower\" from 60 to 120 s on layer 1, "
                 "before \"wind\" from 0 to 90 s (cloud_events[1], line 4) has ended; expected one "
                 "change of a layer's drift after the other");
  EXPECT_EQ(problems_of(wind + "[[cloud_events]]\nkind = 'slower'\nstart = 60\n"),
            std::vector<std::string>{});
  EXPECT_EQ(problems_of(wind + "[[cloud_events]]\nkind = 'gather'\nstart = 30\n"),
            std::vector<std::string>{});
  EXPECT_EQ(problems_of("[[clouds]]\n[[clouds]]\n[[cloud_events]]\nlayer = 1\n"
                        "[[cloud_events]]\nlayer = 2\n"),
            std::vector<std::string>{});
}

TEST(CloudEvents, MayHaveDaysOfASeason) {
  const std::string season =
      "[season]\nfirst = [2026, 9, 1]\nlast = [2026, 10, 1]\n[[season_keys]]\n"
      "date = [2026, 9, 1]\nweathering = 0\n[[clouds]]\n[[cloud_events]]\nkind = 'gather'\n";
  const std::string dated = season + "date = [2026, 9, 10]\n";
  const Scene scene = parse_scene(dated + "until = [2026, 9, 20]\n", "a.toml");
  EXPECT_EQ(scene.cloud_events[0].until, (std::vector<std::int64_t>{2026, 9, 20}));
  EXPECT_EQ(parse_scene(resolved_toml(scene), "a.toml"), scene);
  EXPECT_EQ(problems_of(dated), std::vector<std::string>{});
  expect_problem(
      "[[clouds]]\n[[cloud_events]]\ndate = [2026, 9, 10]\n",
      "a.toml:3:1: cloud_events[1].date: found a day of a season, but the scene is none");
  expect_problem(season + "until = [2026, 9, 10]\n",
                 "a.toml:10:1: cloud_events[1].until: found a day, expected one with date");
  expect_problem(season + "date = [2026, 9, 31]\n",
                 "a.toml:10:1: cloud_events[1].date: found [2026, 9, 31], expected a year, month");
  expect_problem(season + "date = [2026, 10, 2]\n",
                 "a.toml:10:1: cloud_events[1].date: found [2026, 10, 2], expected a day of the "
                 "season, from [2026, 9, 1] to [2026, 10, 1]");
  expect_problem(dated + "until = [2026, 9, 10]\n",
                 "a.toml:11:1: cloud_events[1].until: found [2026, 9, 10], expected a day after");
  expect_problem(dated + "start = 3\n",
                 "a.toml:11:1: cloud_events[1].start: found beside date, expected one of the two");
  expect_problem(dated + "until = [2026, 9, 20]\nduration = 3\n",
                 "a.toml:12:1: cloud_events[1].duration: found beside until");
  expect_problem(dated +
                     "until = [2026, 9, 20]\n[[cloud_events]]\nkind = 'dissipate'\n"
                     "date = [2026, 9, 15]\n",
                 "a.toml:14:1: cloud_events[2].date: found \"dissipate\" from [2026, 9, 15] on for "
                 "60 s on layer 1, before \"gather\" from [2026, 9, 10] to [2026, 9, 20]");
}

TEST(CloudEvents, HaveTheKeysOfTheirKindAndALayer) {
  expect_problem("[[clouds]]\n[[cloud_events]]\nkind = 'gather'\nheading = 10\n",
                 "a.toml:4:1: cloud_events[1].heading: found in a \"gather\" event, expected only "
                 "in: wind");
  expect_problem("[[clouds]]\n[[cloud_events]]\nlayer = 2\n",
                 "a.toml:3:1: cloud_events[1].layer: found 2, but the scene has 1 [[clouds]]");
  expect_problem("[[cloud_events]]\n",
                 "a.toml:1:1: cloud_events[1].layer: found 0, but the scene has 0 [[clouds]]");
  expect_problem("[[clouds]]\n[[cloud_events]]\nkind = 'light'\ncolour = [1, 1]\n",
                 "a.toml:4:1: cloud_events[1].colour: found a list of 2, expected three numbers");
}

TEST(CloudScene, PicturesStartAtTheSceneFile) {
  const auto folder = std::filesystem::temp_directory_path();
  std::ofstream(folder / "wold_cloud.png") << "not looked into";
  const Scene scene =
      parse_scene("[[clouds]]\ntextures = ['wold_cloud.png']\n", (folder / "a.toml").string());
  EXPECT_EQ(scene.clouds[0].textures,
            std::vector<std::string>{(folder / "wold_cloud.png").string()});
  EXPECT_EQ(parse_scene(resolved_toml(scene), "elsewhere/b.toml"), scene);
  std::filesystem::remove(folder / "wold_cloud.png");
}

}  // namespace
}  // namespace wold::scene
