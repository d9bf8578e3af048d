#include "scene/parse.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "scene/problems.h"
#include "scene/write.h"

namespace wold::scene {
namespace {

TEST(Parse, ReadsEveryKindOfValueAndKeepsOtherDefaults) {
  const Scene scene = parse_scene(
      "name = 'hill-1'\nseed = 7\n[grass]\npatch = 1\nlevels = [126, 30]\n[ageing]\n"
      "water = 'cold'\nchlorophyll = [[0, 1], [0.5, 0.75], [1, 0]]\nframes = [0, 0.5]\n"
      "[render]\nrenderer = 'povray'\nsize = [320, 200]\n",
      "a.toml");
  Scene expected;
  expected.name = "hill-1";
  expected.seed = 7;
  expected.grass.patch_m = 1.0;
  expected.grass.lods = {126, 30};
  expected.ageing.water = {"cold", {}};
  expected.ageing.chlorophyll = {"", {{0.0, 1.0}, {0.5, 0.75}, {1.0, 0.0}}};
  expected.ageing.frames = {0.0, 0.5};
  expected.render.renderers = {"povray"};
  expected.render.size_px = {320, 200};
  EXPECT_EQ(scene, expected);
}

TEST(Parse, AnEmptyTextIsTheDefaultScene) {
  EXPECT_EQ(parse_scene("", "a.toml"), Scene{});
  EXPECT_EQ(parse_scene("\xEF\xBB\xBF# only a comment\n[grass]\n", "a.toml"), Scene{});
}

TEST(Parse, NamesPlaceFindingAndExpectation) {
  expect_problem("\n[grass]\n  blades = 0\n",
                 "a.toml:3:12: grass.blades: found 0, expected a whole number from 1 to 20000");
  expect_problem("[grass]\npatch = 50\n",
                 "a.toml:2:9: grass.patch: found 50 m, expected a number from 0.05 to 20 m");
  expect_problem("[grass]\nblades = 2.5\n",
                 "a.toml:2:10: grass.blades: found 2.5, expected a whole");
  expect_problem("[grass]\npatch = '1 m'\n", "a.toml:2:9: grass.patch: found \"1 m\", expected a");
  expect_problem("[grass]\npatch = true\n", "a.toml:2:9: grass.patch: found true, expected a");
  expect_problem("[grass]\npatch = nan\n", "a.toml:2:9: grass.patch: found nan m, expected a");
  expect_problem("[grass]\npatch = inf\n", "a.toml:2:9: grass.patch: found inf m, expected a");
  expect_problem("[grass]\npatch = 1979-05-27\n",
                 "a.toml:2:9: grass.patch: found a date or time of TOML (here");
  expect_problem("[grass.patch]\nx = 1\n", "a.toml:1:1: grass.patch: found a table, expected a");
  expect_problem("seed = -1\n", "a.toml:1:8: seed: found -1, expected a whole number from 0 to");
  expect_problem("name = '../up'\n", "a.toml:1:8: name: found \"../up\", expected a file name");
  expect_problem(
      "[render]\nrenderer = 'blendr'\n",
      "a.toml:2:12: render.renderer: found \"blendr\", expected \"blender\", \"povray\"");
}

TEST(Parse, NamesTheItemOfAList) {
  expect_problem("[render]\nsize = [640, 8]\n",
                 "a.toml:2:14: render.size: found 8 px (item 2), expected 2 whole numbers from 16");
  expect_problem("[render]\nsize = [640]\n",
                 "a.toml:2:8: render.size: found a list of 1, expected 2");
  expect_problem("[render]\nsize = [640, 'x']\n",
                 "a.toml:2:14: render.size: found \"x\", expected 2");
  expect_problem("[grass]\nlevels = [254, 100]\n",
                 "a.toml:2:16: grass.levels: found 100 voxels (item 2)");
  expect_problem("[grass]\nlevels = [62, 126]\n",
                 "a.toml:2:15: grass.levels: found 126 after 62 (item 2)");
  expect_problem("[grass]\nkey_frames = [0, 0.5, 0.5, 1]\n",
                 "a.toml:2:23: grass.key_frames: found 0.5 after 0.5 (item 3)");
  expect_problem("[grass]\nkey_frames = [0, 0.5]\n",
                 "a.toml:2:18: grass.key_frames: found 0.5 as the last (item 2)");
  expect_problem("[ageing]\nframes = []\n", "a.toml:2:10: ageing.frames: found a list of 0");
}

TEST(Parse, ChecksCurves) {
  expect_problem("[ageing]\nwater = 'drought'\n",
                 "a.toml:2:9: ageing.water: found \"drought\", expected \"stand");
  expect_problem("[ageing]\nwater = []\n", "a.toml:2:9: ageing.water: found a list of 0");
  expect_problem("[ageing]\nwater = [[0, 1], [1]]\n",
                 "a.toml:2:18: ageing.water: found a list of 1");
  expect_problem("[ageing]\nwater = [[0, 1]]\n",
                 "a.toml:2:9: ageing.water: found a list of 1, expected \"standard\", \"ample\" or "
                 "\"cold\", or a list of 2 to 1000 points");
  expect_problem("[ageing]\nchlorophyll = [[0, 1], [0.5, nan], [1, 0]]\n",
                 "a.toml:2:24: ageing.chlorophyll: found [0.5, nan] (item 2)");
  expect_problem("[ageing]\nchlorophyll = [[0, 1], [0.5, inf], [1, 0]]\n",
                 "a.toml:2:24: ageing.chlorophyll: found [0.5, inf] (item 2)");
  expect_problem("[ageing]\nchlorophyll = [[0, 1], [0.6, 0.5], [0.5, 0.6], [1, 0]]\n",
                 "a.toml:2:36: ageing.chlorophyll: found [0.5, 0.6] after [0.6, 0.5] (item 3)");
  expect_problem("[ageing]\nwater = [[0, 1], [1, 1.5]]\n",
                 "a.toml:2:18: ageing.water: found [1, 1.5] (item 2)");
  expect_problem("[ageing]\nwater = [[0, 1], [0, 0.5], [1, 0]]\n",
                 "a.toml:2:18: ageing.water: found [0, 0.5]");
  expect_problem("[ageing]\nwater = [[0.1, 1], [1, 0]]\n",
                 "a.toml:2:10: ageing.water: found 0.1 as the first");
  expect_problem("[ageing]\nwater = [[0, 1], [0.9, 0]]\n",
                 "a.toml:2:18: ageing.water: found 0.9 as the last");
}

TEST(Parse, ReadsAndChecksAListOfAgeingRates) {
  const Scene scene = parse_scene(
      "[grass]\nmingle = ['early', [[0, 0], [0.5, 0.5], [1, 0.5]], 'slow']\n", "a.toml");
  const std::vector<CurveChoice> rates = {
      {"early", {}}, {"", {{0.0, 0.0}, {0.5, 0.5}, {1.0, 0.5}}}, {"slow", {}}};
  EXPECT_EQ(scene.grass.mingle, rates);
  const Overrides overrides = {"grass.mingle=[\"late\", [[0, 0.25], [1, 1]]]"};
  EXPECT_EQ(parse_scene("", "a.toml", overrides).grass.mingle,
            (std::vector<CurveChoice>{{"late", {}}, {"", {{0.0, 0.25}, {1.0, 1.0}}}}));

  const auto expect_rates_problem = [](const std::string& rates_text, const std::string& start) {
    expect_problem("[grass]\nmingle = " + rates_text + "\n", "a.toml:2:" + start);
  };
  expect_rates_problem("'late'",
                       "10: grass.mingle: found \"late\", expected a list of 0 to 32 cur");
  expect_rates_problem("['late', 'erly']",
                       "19: grass.mingle: found \"erly\" (item 2), expected a list of 0 to 32 "
                       "curves, each \"steady\", \"early\", \"late\", \"sudden\", \"slow\" or "
                       "\"evergreen\", or a list of 2 to 1000 points [weathering degree, value], "
                       "the degree rising from 0 to 1, values from 0 to 1, none smaller than the "
                       "one before");
  expect_rates_problem("['late', 3]", "19: grass.mingle: found 3, expected a list");
  expect_rates_problem("[[0, 0], [1, 1]]", "12: grass.mingle: found 0, expected a list");
  expect_rates_problem("['late', []]", "19: grass.mingle: found a list of 0, expected");
  expect_rates_problem("['late', [[0, 0]]]", "19: grass.mingle: found a list of 1 (item 2)");
  expect_rates_problem("[[[0, 0], [0.5, 'x'], [1, 1]]]", "20: grass.mingle: found a list of 2");
  expect_rates_problem("[[[0, 0], [0.5, nan], [1, 1]]]",
                       "20: grass.mingle: found [0.5, nan] (item 1, point 2)");
  expect_rates_problem("[[[0, 0], [nan, 0.5], [1, 1]]]",
                       "20: grass.mingle: found [nan, 0.5] (item 1, point 2)");
  expect_rates_problem("[[[0, 0], [1, 1.01]]]",
                       "20: grass.mingle: found [1, 1.01] (item 1, point 2)");
  expect_rates_problem("['late', [[0, 0], [0.7, 0.2], [0.6, 0.3], [1, 1]]]",
                       "40: grass.mingle: found [0.6, 0.3] after [0.7, 0.2] (item 2, point 3)");
  expect_rates_problem("[[[0, 0], [0.5, 0.6], [1, 0.5]]]",
                       "32: grass.mingle: found [1, 0.5] after [0.5, 0.6] (item 1, point 3)");
  expect_rates_problem("[[[0.1, 0], [1, 1]]]",
                       "12: grass.mingle: found 0.1 as the first weathering degree (item 1, point");
  expect_rates_problem(
      "[[[0, 0], [0.9, 1]]]",
      "20: grass.mingle: found 0.9 as the last weathering degree (item 1, point 2");
  expect_problem("", "--set grass.mingle=[\"lat\"]: grass.mingle: found \"lat\" (item 1), expected",
                 {"grass.mingle=[\"lat\"]"});
}

TEST(Parse, SuggestsTheNearestKnownName) {
  expect_problem("[grass]\nblade = 3\n",
                 "a.toml:2:1: unknown key \"grass.blade\"; did you mean \"grass.blades\"?");
  expect_problem("[gras]\nblades = 3\nx = 1\n",
                 "a.toml:1:2: unknown table [gras]; did you mean \"grass\"?");
  expect_problem("blades = 3\n",
                 "a.toml:1:1: unknown key \"blades\"; did you mean \"grass.blades\"?");
  expect_problem("zebra = 3\n", "a.toml:1:1: unknown key \"zebra\"");
  expect_problem("grass = 3\n", "a.toml:1:1: grass: found 3, expected the table [grass]");
  expect_problem("[[grass]]\n", "a.toml:1:3: grass: found a list of 1, expected the table [grass]");
  expect_problem("[seed]\nx = 1\n", "a.toml:1:2: seed: found a table, expected a whole number");
  expect_problem("\"grass.blades\" = 3\n", "a.toml:1:1: unknown key \"\"grass.blades\"\"");
}

TEST(Parse, ReportsEverythingAtOnceFromTheTop) {
  const auto problems = problems_of(
      "sed = 1\n[sun]\nelevation = -5\n[grass]\nblades = 0\npatch = 'x'\n"
      "[camera]\neye = [50, 1]\n[meteor]\nrain = 1\n",
      {"render.samples=0", "nonsense"});
  ASSERT_EQ(problems.size(), 8u);
  EXPECT_EQ(problems[0], "a.toml:1:1: unknown key \"sed\"; did you mean \"seed\"?");
  expect_start(problems[1], "a.toml:3:13: sun.elevation: ");
  expect_start(problems[2], "a.toml:5:10: grass.blades: ");
  expect_start(problems[3], "a.toml:6:9: grass.patch: ");
  expect_start(problems[4], "a.toml:8:1: camera.eye: ");
  EXPECT_EQ(problems[5], "a.toml:9:2: unknown table [meteor]");
  expect_start(problems[6], "--set render.samples=0: render.samples: ");
  expect_start(problems[7], "--set nonsense: expected key=valu");
}

TEST(Parse, ChecksKeysAgainstEachOther) {
  expect_problem("[camera]\neye = [20, 43]\n",
                 "a.toml:2:1: camera.eye: found [20, 43] m, expected a place inside");
  expect_problem("[camera]\neye = [21, 20]\n",
                 "a.toml:2:1: camera.target: found [21, 20] m, expected another");
  expect_problem("[ageing]\nvein_shrinkage = 0.6\n",
                 "a.toml:2:1: ageing.vein_shrinkage: found 0.6, expected less than 0.6");
  expect_problem("[ageing]\nmesophyll_shrinkage = 0.1\n",
                 "a.toml:2:1: ageing.vein_shrinkage: found 0.15");
  expect_problem("[grass]\npatch = 2\n[terrain]\nsize = 1\n[camera]\neye=[0,0]\ntarget=[1,1]\n",
                 "a.toml:2:1: grass.patch: found 2 m, expected at most 1 m (terrain.size)");
  expect_problem(
      "[grass]\nblades = 1\nmingle = ['early', 'late']\n",
      "a.toml:3:1: grass.mingle: found 2 samples, expected at most one for each of the 1");
  expect_problem("[grass]\npatch = 0.05\nheight = 0.1\nwidth = 0.05\nblades = 1\n",
                 "a.toml:4:1: grass.width: found 0.05 m, with grass.width_spread up to 0.0775 m, "
                 "expected less than grass.patch (0.05 m)");
  expect_problem("[grass]\nwidth = 0.002\n[ageing]\ndroop_rule = \"elastica\"\n",
                 "a.toml:2:1: grass.keel_depth: found 0.0011 m, expected at most 0.001 m, half of");
  EXPECT_NO_THROW(parse_scene("[grass]\nwidth = 0.002\n", "a.toml"));
  expect_problem("[ageing]\ndroop_rule = \"elastic\"\n",
                 "a.toml:2:14: ageing.droop_rule: found \"elastic\", expected \"paper\"");
  expect_problem("[fur]\nclumps = 3\n[ageing]\nmotion = \"points\"\n",
                 "a.toml:4:1: ageing.motion: found \"points\", expected \"closed_form\" for fur");
  expect_problem("[ageing]\nmerge_distance = -1\n", "a.toml:2:18: ageing.merge_distance: found -1");
  // A size that is wrong by itself is not held against the camera as well.
  expect_problem("[terrain]\nsize = -5\n[camera]\neye = [100, 5]\n",
                 "a.toml:2:8: terrain.size: found -5 m");
}

TEST(Parse, RefusesWhatIsNotToml) {
  expect_problem("[grass]\nblades =\n", "a.toml:2:9: not valid TOML: ");
  expect_problem("[grass]\nblades = 3\nblades = 4\n", "a.toml:3:10: not valid TOML: ");
  expect_problem("[grass]\n[grass]\n", "a.toml:2:1: not valid TOML: ");
  expect_problem("name = '\xff\xfe'\n", "a.toml:1:8: not valid TOML: ");
  expect_problem(std::string("\x7f"
                             "ELF\0\0\1",
                             7),
                 "a.toml:1:1: not valid TOML: ");
}

TEST(Parse, RefusesDeepNestingAndEndlessText) {
  std::string keys = "a";
  for (int i = 0; i < 200000; ++i) keys += i % 2 == 0 ? ".1" : ".1.a";
  expect_problem(keys + " = 1\n", "a.toml: tables nested far too deep");
  expect_problem("[" + keys + "]\n", "a.toml: tables nested far too deep");
  expect_problem("x = " + std::string(100000, '['), "a.toml:1:");
  expect_problem(std::string(std::size_t{2} << 20, '#'), "a.toml: too much text");
}

TEST(Parse, TheLongestSceneIsAccepted) {
  std::string text = "ageing.frames = [0.0";
  for (int i = 1; i < 10000; ++i) text += ", 0." + std::to_string(100000 + i);
  EXPECT_EQ(parse_scene(text + "]\n", "a.toml").ageing.frames.size(), 10000u);
}

TEST(Parse, ReadsRenderersAsAWordOrAList) {
  const auto renderers = [](const std::string& value) {
    return parse_scene("[render]\nrenderer = " + value + "\n", "a.toml").render.renderers;
  };
  const std::vector<std::string> both = {"blender", "povray"};
  EXPECT_EQ(renderers("'both'"), both);
  EXPECT_EQ(renderers("['povray', 'blender', 'povray']"), both)
      << "in the table's order, each once";
  EXPECT_EQ(renderers("['both']"), both);
  EXPECT_EQ(renderers("['povray']"), std::vector<std::string>{"povray"});
  EXPECT_EQ(renderers("'povray'"), std::vector<std::string>{"povray"});
}

TEST(Parse, NamesTheRendererInAListThatIsNone) {
  expect_problem("[render]\nrenderer = ['blender', 'cycles']\n",
                 "a.toml:2:24: render.renderer: found \"cycles\" (item 2), expected \"blender\", ");
  expect_problem("[render]\nrenderer = []\n",
                 "a.toml:2:12: render.renderer: found a list of 0, expected \"blender\", ");
  expect_problem("[render]\nrenderer = 3\n",
                 "a.toml:2:12: render.renderer: found 3, expected \"blender\", ");
}

TEST(Overrides, WinOverTheTextInTheirOrder) {
  const Overrides overrides = {"grass.blades=5",
                               "grass.blades = 6",
                               "render.renderer=blender",
                               "ageing.water=[[0, 1], [1, 0.5]]",
                               "name=\"x y\"",
                               "name=hill_2"};
  const auto problems = problems_of("[grass]\nblades = 3\n", overrides);
  ASSERT_EQ(problems.size(), 1u);
  expect_start(problems[0], "--set name=\"x y\": name: found \"x y\", ex");
  const Overrides good = {overrides[0], overrides[1], overrides[2], overrides[3], overrides[5]};
  const Scene scene = parse_scene("[grass]\nblades = 3\n", "a.toml", good);
  EXPECT_EQ(scene.grass.blades, 6);
  EXPECT_EQ(scene.render.renderers, std::vector<std::string>{"blender"});
  EXPECT_EQ(scene.ageing.water, (CurveChoice{"", {{0.0, 1.0}, {1.0, 0.5}}}));
  EXPECT_EQ(scene.name, "hill_2");
}

TEST(Overrides, AreCheckedLikeTheText) {
  expect_problem("", "--set grass.blades=0: grass.blades: found 0, expected a whole number from 1",
                 {"grass.blades=0"});
  expect_problem("", "--set grass.blade=1: unknown key \"grass.blade\"; did you mean \"grass.bl",
                 {"grass.blade=1"});
  expect_problem("", "--set render.size=[640, 8]: render.size: found 8 px (item 2)",
                 {"render.size=[640, 8]"});
  expect_problem("", "--set camera.eye=[99, 9]: camera.eye: found [99, 9] m, expected a place",
                 {"camera.eye=[99, 9]"});
  expect_problem("", "--set grass=1: grass: found 1, expected the table [grass]", {"grass=1"});
  expect_problem("", "--set seed=: \"\" is not a TOML value", {"seed="});
  expect_problem("", "--set =3: unknown key \"\"", {"=3"});
  expect_problem("", "--set seed=[1: \"[1\" is not a TOML value", {"seed=[1"});
  expect_problem("", "--set seed=1?grass.blades=2: expected key=value", {"seed=1\ngrass.blades=2"});
}

TEST(ReadScene, ReadsAFileAndNamesOneItCannotRead) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "wold_read_scene";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.toml") << "seed = 9\n";
  EXPECT_EQ(read_scene(folder / "a.toml").seed, 9u);
  for (const std::string name : {"missing.toml", "."}) {
    const auto path = folder / name;
    try {
      read_scene(path);
      ADD_FAILURE() << path << " was read";
    } catch (const InputError& error) {
      EXPECT_EQ(error.problems().at(0).where.file, path.string());
      EXPECT_EQ(error.code(), ExitCode::wrong_input);
    }
  }
  EXPECT_THROW(read_scene("/dev/zero"), InputError);
  std::filesystem::remove_all(folder);
}

// No file is looked for.
TEST(Parse, FilesStartAtTheSceneOrAtTheCommandLine) {
  const std::string scene = "/nowhere/a.toml";
  const std::string text = "[terrain]\nelevation = 'wold \"heights\".tif'\n";
  const Scene read = parse_scene(text, scene);
  EXPECT_EQ(read.terrain.elevation, "/nowhere/wold \"heights\".tif");
  EXPECT_EQ(parse_scene(resolved_toml(read), "elsewhere/b.toml"), read);
  const std::vector<std::string> overrides = {"terrain.elevation=none.tif"};
  EXPECT_EQ(parse_scene(text, scene, overrides).terrain.elevation,
            std::filesystem::current_path() / "none.tif");
  expect_problem("[terrain]\ncentre = [3]\n", "a.toml:2:1: terrain.centre: found a list of 1");
}

}  // namespace
}  // namespace wold::scene
