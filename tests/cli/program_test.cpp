#include "program.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "support/places.h"

namespace wold::test {
namespace {

/// Data on stdout alone.
void expect_answer(const Result& result, const std::string& part) {
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  expect_contains(result.out, part);
}

/// Exit code 2, nothing on stdout, every line on stderr an error.
void expect_refusal(const Result& result, const std::string& part) {
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.substr(0, 7), "error: ");
  expect_contains(result.err, part);
}

TEST_F(Program, HelpListsEveryCommandAndEachHasAnExample) {
  const Result help = wold("--help");
  for (const std::string command :
       {"render", "generate", "plan", "task", "check", "inspect", "compare", "curves", "film",
        "report", "preview", "maps", "new", "wind", "doctor", "extension"}) {
    expect_answer(help, "\n  " + command + " ");
    expect_answer(wold(command + " --help"), "Example:\n  wold " + command + " ");
  }
}

TEST_F(Program, VersionIsTheProjects) {
  const Result result = wold("--version");
  expect_answer(result, "wold ");
  const std::string number = result.out.substr(5, result.out.find('\n') - 5);
  expect_contains(read_file(tests_folder() / "../CMakeLists.txt"), "VERSION " + number + " ");
}

TEST_F(Program, VersionNamesBuildLibrariesAndRenderers) {
  const Result none =
      wold("--version", "PATH=/nonexistent WOLD_BLENDER= WOLD_POVRAY= WOLD_FFMPEG=");
  const std::string revision = read_file(build_folder() / "share/wold/revision");
  EXPECT_EQ(revision.find("unknown"), std::string::npos) << "built outside git";
  expect_answer(none, "\nrevision   " + revision);
  for (const std::string part :
       {"\nbuilt by   ", "\nlibraries  OpenVDB ", ", GDAL ", ", PROJ ",
        "\nrenderer   Blender: missing\n", "\nrenderer   POV-Ray: missing\n",
        "\nfilms      FFmpeg: missing\n"})
    expect_contains(none.out, part);
  write("pov.sh", "#!/bin/sh\necho 'POV-Ray 3.8.0-beta.2'\n");
  const std::string program = (folder_ / "pov.sh").string();
  fs::permissions(program, fs::perms::owner_all);
  expect_answer(
      wold("--version", "WOLD_BLENDER=/bin/true WOLD_POVRAY='" + program + "'"),
      "\nrenderer   Blender: missing\nrenderer   POV-Ray 3.8.0-beta.2 (" + program + ")\n");
}

// As of a package, wherever it is unpacked; nothing else of this machine may be tried.
TEST_F(Program, FindsItsFilesFromWhereItIs) {
  fs::create_directories(folder_ / "there/bin");
  fs::create_directories(folder_ / "there/share/wold");
  fs::copy_file(wold_program(), folder_ / "there/bin/wold");
  write("a.toml", "");
  const std::string curves = "there/bin/wold curves a.toml --out a.csv";
  const Result missing = shell(curves);
  EXPECT_EQ(missing.code, 4);
  expect_contains(missing.err, "there/share/wold/models");
  const fs::path sources = tests_folder().parent_path();
  EXPECT_EQ(missing.err.find((sources / "models").string()), std::string::npos) << missing.err;
  for (const std::string folder : {"models", "templates"})
    fs::create_directory_symlink(sources / folder, folder_ / "there/share/wold" / folder);
  EXPECT_EQ(shell(curves).code, 0);
  fs::rename(folder_ / "there", folder_ / "elsewhere");
  EXPECT_EQ(shell("elsewhere/bin/wold curves a.toml --out b.csv").code, 0);
}

TEST_F(Program, HelpKeysListsTheKeysAsMarkdown) {
  expect_answer(wold("--help-keys"),
                "| `render.timeout` | `60.0` | a number from 0.01 to 10080 min |");
}

TEST_F(Program, UsageErrorsAreExitCodeTwo) {
  write("a.toml", "");
  expect_refusal(wold(""), "a command was expected");
  expect_refusal(wold("rendr a.toml"), "unknown command \"rendr\"; did you mean \"render\"?");
  expect_refusal(wold("render"), "SCENE");
  expect_refusal(wold("check a.toml b.toml"), "b.toml");
  expect_refusal(wold("render a.toml --size 960"), "--size: found \"960\", expected WIDTHxHEIGHT");
  expect_refusal(wold("render a.toml --frames 1,x"), "--frames: found \"x\" in \"1,x\"");
  expect_refusal(wold("render a.toml --frames 3-1"), "--frames: found \"3-1\"");
  expect_refusal(wold("render a.toml --frames 1-2000000000"), "--frames: found");
  expect_refusal(wold("render a.toml --frames 4 --dry-run"), "expected frames from 1 to 3");
  expect_refusal(wold("render a.toml --memory 3X"),
                 "--memory: found 3X, expected a whole size of 1M or more");
  expect_refusal(wold("render a.toml --keep nothing"),
                 "--keep: found nothing, expected one of all");
  expect_refusal(wold("generate a.toml --keep pictures"),
                 "--keep: found pictures, expected one of all, scenes");
  expect_refusal(wold("render a.toml --threads many"), "--threads");
  expect_refusal(wold("render a.toml --renderer blendr --dry-run"), "render.renderer: found");
}

TEST_F(Program, CheckPrintsTheResolvedSceneWhichResolvesToItself) {
  write("a.toml", "[grass]\nblades = 12\n");
  const Result first = wold("check a.toml --set seed=5 --set 'render.size=[64, 32]'");
  expect_answer(first, "\nblades = 12\n");
  expect_answer(first, "\nseed = 5\n");
  expect_answer(first, "\nsize = [64, 32]\n");
  write("b.toml", first.out);
  EXPECT_EQ(wold("check b.toml").out, first.out);
}

TEST_F(Program, SceneErrorsAreListedLineByLine) {
  write("a.toml", "sed = 1\n[grass]\nblades = 0\n");
  const Result result = wold("check a.toml --set sun.elevation=-5");
  expect_refusal(result, "error: a.toml:1:1: unknown key \"sed\"; did you mean \"seed\"?\n");
  expect_contains(result.err, "\nerror: a.toml:3:10: grass.blades: found 0, expected");
  expect_contains(result.err, "\nerror: --set sun.elevation=-5: sun.elevation: found -5 deg,");
  expect_refusal(wold("check a.toml --verbos"), "unknown option \"--verbos\" of wold check; wold");
  expect_refusal(wold("render a.toml --sise 3x3"),
                 "unknown option \"--sise\" of wold render; did you mean \"--size\"?");
  expect_refusal(wold("--versio"),
                 "unknown option \"--versio\" of wold; did you mean \"--version\"?");
  expect_refusal(wold("check a.toml --set seed=5 grass.blades=9"),
                 "\"grass.blades=9\": found a key by itself, expected --set before each");
  expect_refusal(wold("check missing.toml"), "missing.toml: cannot read the scene file: No such");
  expect_refusal(wold("check ."), "it is a folder");
  expect_refusal(wold("check a"), "No such file or directory; did you mean a.toml?");
}

TEST_F(Program, ShorthandsSetTheSameKeysAndDryRunWritesNothing) {
  write("a.toml", "");
  for (const std::string command : {"render", "generate"})
    expect_answer(wold(command + " a.toml --dry-run --set grass.blades=9 --size 320x200 --samples 3"
                                 " --renderer povray --frames 3,1-2,1 --out b"),
                  "frames 1-3 of 3, 320 x 200 px, 3 samples, renderer povray, into b\n");
  expect_answer(wold("render a.toml --dry-run --frames 1,3 --set name=heath"),
                "heath: frames 1,3 of 3, 960 x 540 px");
  const Result render = wold("render a.toml --dry-run --frames 1,3");
  expect_answer(render, "\n  scenes  2 of 2 to do; each ");
  expect_answer(render, "\n  blender 2 of 2 to do; each ");
  EXPECT_EQ(render.out, wold("plan a.toml --frames 1,3").out);
  EXPECT_EQ(wold("generate a.toml --dry-run").out.find("blender 3 of"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "b"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Program, EveryCommandThatReadsASceneTakesItsShorthands) {
  write("a.toml", "");
  write("dem.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 100\n1 2\n3 4\n");
  std::string days = "date,tmin_c,tmax_c,precipitation_mm\n";
  for (int day = 1; day <= 30; ++day) days += fmt::format("2026-06-{:02},4,14,2\n", day);
  write("days.csv", days);
  const std::string shorthands =
      " --renderer povray --samples 3 --grass blades --size 320x200 --terrain dem.asc";
  const std::string season = " --set 'season.first=[2026,6,2]' --set 'season.last=[2026,6,9]'";
  const Result check = wold("check a.toml --weather days.csv" + shorthands + season);
  EXPECT_EQ(check.code, 0) << check.err;
  for (const char* line : {"\nrenderer = \"povray\"\n", "\nsamples = 3\n", "\ngrass = \"blades\"\n",
                           "\nsize = [320, 200]\n", "/dem.asc\"\n", "/days.csv\"\n"})
    expect_contains(check.out, line);
  for (const std::string command :
       {"render", "generate", "plan", "task", "check", "preview", "curves"}) {
    const std::string help = wold(command + " --help").out;
    for (const char* option :
         {"--renderer", "--samples", "--grass", "--size", "--terrain", "--weather", "--set"})
      EXPECT_NE(help.find(option), std::string::npos) << command << " " << option;
  }
  EXPECT_EQ(wold("curves a.toml --out a.csv" + shorthands).code, 0);
}

TEST_F(Program, CheckNamesFilesThatAreNotThereWithTheirLine) {
  for (const char* key : {"elevation", "surroundings", "cover", "photo"}) {
    write("a.toml", fmt::format("[terrain]\n{} = 'gone.tif'\n", key));
    expect_refusal(wold("check a.toml"), fmt::format("a.toml:2:1: terrain.{}: found", key));
  }
}

TEST_F(Program, NewWritesASceneOnceAndNeverReplacesIt) {
  const Result result = wold("new heath");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out, "");
  expect_answer(wold("check heath.toml"), "\nname = \"heath\"\n");
  write("heath.toml", "seed = 3\n");
  expect_refusal(wold("new heath"), "heath.toml exists already");
  EXPECT_EQ(read_file(folder_ / "heath.toml"), "seed = 3\n");
  expect_refusal(wold("new ../heath"), "expected a file name");
}

TEST_F(Program, NewHasAStarterSceneOfEachKind) {
  for (const std::string kind : {"hillside", "mountain", "clouds", "snow", "season"}) {
    EXPECT_EQ(wold(fmt::format("new {0} --kind {0}", kind)).code, 0);
    expect_answer(wold(fmt::format("check {}.toml", kind)), fmt::format("\nname = \"{}\"\n", kind));
  }
  EXPECT_EQ(wold("preview clouds.toml --set terrain.size=36").out, "out/clouds/preview.png\n");
  expect_refusal(wold("new x --kind hill"),
                 "--kind: found hill, expected one of hillside, mountain, ");
}

TEST_F(Program, WritesSceneOfARealPlaceThatCanBeChecked) {
  std::string model = "ncols 60\nnrows 60\nxllcorner 254.5\nyllcorner 40\ncellsize 0.001\n";
  for (int i = 0; i < 3600; ++i)
    model += fmt::format("{} ", 1500 + (i % 60) * 5 + (i / 60 % 20) * 8);
  write("my \"alps\".asc", model);
  for (const char* kind : {"hillside", "season"}) {
    const Result made =
        wold(fmt::format("new of_{0} --kind {0} --terrain 'my \"alps\".asc'", kind));
    EXPECT_EQ(made.code, 0) << made.err;
    const Result checked = wold(fmt::format("check of_{}.toml", kind));
    EXPECT_EQ(checked.code, 0) << checked.err;
    EXPECT_EQ(checked.err, "");
    expect_contains(checked.out, "system = \"EPSG:4326\"");
  }
  expect_contains(wold("check of_season.toml").out, "longitude = -105.47");
}

TEST_F(Program, WritesNoSceneOfAPlaceThatIsNone) {
  write("small.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.6\n1 2\n3 4\n");
  write("no.asc", "no model\n");
  std::string polar = "ncols 20\nnrows 20\nxllcorner 20\nyllcorner 69.6\ncellsize 0.01\n";
  for (int i = 0; i < 400; ++i) polar += fmt::format("{} ", i % 7);
  write("polar.asc", polar);
  expect_refusal(wold("new a --terrain small.asc"), "expected 10 m or more");
  expect_refusal(wold("new a --terrain no.asc"), "terrain.elevation: ");
  expect_refusal(wold("new a --kind season --terrain polar.asc"), "sun.time");
  EXPECT_EQ(wold("new a --terrain none.asc").code, 4);
  EXPECT_NE(wold("new a --terrain ''").code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "a.toml"));
}

/// A df3 file by its published layout: three big-endian 16-bit sizes, then one
/// byte per voxel.
std::string df3(char voxel) { return std::string("\0\2\0\1\0\1", 6) + '\x10' + voxel; }

TEST_F(Program, CompareTellsEqualFromDifferent) {
  write("a.df3", df3('\x20'));
  write("same.df3", df3('\x20'));
  write("other.df3", df3('\x7f'));
  const Result same = wold("compare a.df3 same.df3");
  expect_answer(same, "\"same\"");
  EXPECT_TRUE(nlohmann::json::parse(same.out).at("same").get<bool>());
  const Result other = wold("compare a.df3 other.df3");
  EXPECT_EQ(other.code, 1);
  EXPECT_EQ(other.err.find("a.df3: rmse is 0.2634, at most 0.005 is allowed;"), 0U) << other.err;
  EXPECT_FALSE(nlohmann::json::parse(other.out).at("same").get<bool>());
  EXPECT_EQ(wold("compare a.df3 other.df3 --rmse 1 --soft 1 --share 1 --hard 1").code, 0);
  const Result missing = wold("compare a.df3 missing.df3");
  EXPECT_EQ(missing.code, 4);
  expect_contains(missing.err, "missing.df3");
  expect_refusal(wold("compare a.df3"), "WANT");
  for (const std::string limit : {"-1", "nan"})
    expect_refusal(wold("compare a.df3 same.df3 --rmse=" + limit), "--rmse: found " + limit);
}

TEST_F(Program, InspectDescribesSoundAndDamagedFiles) {
  write("a.df3", df3('\x20'));
  write("cut.df3", df3('\x20').substr(0, 7));
  expect_answer(wold("inspect a.df3"), "df3");
  const Result json = wold("inspect --json a.df3 a.df3");
  EXPECT_EQ(json.code, 0);
  EXPECT_EQ(nlohmann::json::parse(json.out).size(), 2u);
  EXPECT_EQ(wold("inspect a.df3 cut.df3").code, 4);
  EXPECT_EQ(wold("inspect missing.df3").code, 4);
}

TEST_F(Program, UnwritableOutputIsExitCodeFour) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  write("a.toml", "");
  const Result result = wold("check a.toml >/dev/full");
  EXPECT_EQ(result.code, 4);
  expect_contains(result.err, "error: cannot write to standard output: No space");
}

}  // namespace
}  // namespace wold::test
