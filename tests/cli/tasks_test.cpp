#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/files.h"
#include "small_film.h"
#include "support/sanitized.h"

/// A film as single tasks: what farms run and what `wold plan` lists.
namespace wold::test {
namespace {

using nlohmann::json;
using testing::IsEmpty;

class Tasks : public SmallFilm {
 protected:
  /// The small film by a script in Blender's place.
  Result film(const std::string& command, const std::string& options = "") const {
    return wold(command + " --renderer blender " + options, blender_played_by(play));
  }
  Result task(const std::string& out, const std::string& name) const {
    return film("task small.toml " + name, "--quiet --out " + out);
  }
  std::string task_line(const std::string& out, const std::string& name) const {
    return command("task small.toml " + name + " --renderer blender --quiet --out " + out,
                   blender_played_by(play));
  }
  void render(const std::string& out, const std::string& options = "") const {
    const Result result = film("render small.toml --quiet", "--out " + out + " " + options);
    ASSERT_EQ(result.code, 0) << result.err;
  }
  json plan(const std::string& options) const {
    const Result result = film("plan small.toml --json", options);
    EXPECT_EQ(result.code, 0) << result.err;
    return json::parse(result.out);
  }

  /// Hashes by path that a manifest lists, but of logs.
  std::map<std::string, std::string> listed(const std::string& out) const {
    std::map<std::string, std::string> hashes;
    const json manifest = json::parse(read_file(folder_ / out / "manifest.json"));
    for (const json& file : manifest.at("files"))
      if (file.at("stage") != "logs") hashes[file.at("path")] = file.at("hash");
    return hashes;
  }

  static constexpr const char* play = "cp $good \"$out\"";
};

TEST_F(Tasks, InAnyOrderAndTwiceAtOnceMakeTheBytesOfRender) {
  render("local");
  EXPECT_EQ(calls(), "1 2 ");
  // Each stage twice at the same time, as when a lost node's task is started again.
  for (const std::string stage : {"texels", "scenes", "blender"}) {
    std::string line = "true; ";
    for (const std::string index : {" 2", " 1", " 2", " 1"})
      line += "( " + task_line("farm", stage + index) + ") || touch failed & ";
    ASSERT_EQ(shell(line + "wait; test ! -e failed").code, 0) << stage;
  }
  EXPECT_FALSE(fs::exists(folder_ / "farm/manifest.json")) << "no task's to write";
  EXPECT_THAT(different(contents("farm"), contents("local")), IsEmpty());
  expect_nothing_half_written("farm");
  calls();
  render("farm");
  EXPECT_EQ(calls(), "") << "all is there";
  EXPECT_THAT(different(listed("farm"), listed("local")), IsEmpty());
}

TEST_F(Tasks, WhatIsDoneIsLeftAlone) {
  render("out", "--frames 1-2");
  calls();
  const auto before = times("out");
  for (const std::string name : {"texels 1", "scenes 2", "blender 1"})
    EXPECT_EQ(task("out", name).code, 0);
  EXPECT_EQ(calls(), "");
  EXPECT_THAT(different(times("out"), before), IsEmpty());
}

TEST_F(Tasks, SayWhatHasToBeDoneBefore) {
  const Result scenes = task("out", "scenes 1");
  EXPECT_EQ(scenes.code, 4);
  expect_contains(scenes.err, "run the task \"texels ");
  const Result picture = task("out", "blender 2");
  EXPECT_EQ(picture.code, 4);
  expect_contains(picture.err, "needs the files of \"scenes 2\", which has to be run first");
  EXPECT_EQ(calls(), "");
}

TEST_F(Tasks, OthersThanThePlansAreRefused) {
  const Result stage = task("out", "bake 1");
  EXPECT_EQ(stage.code, 2);
  expect_contains(stage.err, "expected one of this scene's: texels, scenes, blender");
  const Result index = task("out", "'scenes' 3");
  EXPECT_EQ(index.code, 2);
  expect_contains(index.err, "found task scenes 3, expected one of scenes: 1-2");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Tasks, AFailureLeavesNothingThatLooksDone) {
  for (const std::string name : {"texels 1", "texels 2", "scenes 1"})
    ASSERT_EQ(task("out", name).code, 0);
  const Result failed =
      wold("task small.toml blender 1 --renderer blender --out out", blender_played_by("exit 5"));
  EXPECT_EQ(failed.code, 3);
  expect_nothing_half_written("out");
  calls();
  EXPECT_EQ(task("out", "blender 1").code, 0);
  EXPECT_EQ(calls(), "1 ");
}

TEST_F(Tasks, PlanCountsWhatIsToDoAndSaysWhy) {
  const json fresh = plan("--out out");
  EXPECT_FALSE(fs::exists(folder_ / "out")) << "a plan writes nothing";
  std::map<std::string, int> runs;
  for (const json& stage : fresh.at("stages")) {
    runs[stage.at("stage")] = stage.at("runs");
    EXPECT_EQ(stage.at("groups").at(0).at("runs"), "yes") << stage;
  }
  EXPECT_EQ(runs, (std::map<std::string, int>{{"texels", 2}, {"scenes", 2}, {"blender", 2}}));
  render("out");
  const json rendered = plan("--out out");
  for (const json& stage : rendered.at("stages")) {
    EXPECT_EQ(stage.at("runs"), 0) << stage;
    EXPECT_EQ(stage.at("perhaps"), 0) << stage;
    EXPECT_EQ(stage.at("groups").at(0).at("runs"), "no") << stage;
    EXPECT_EQ(stage.at("estimate").at("from"), "records") << stage;
  }
  fs::remove(folder_ / "out/frames/blender/0002.png");
  const auto before = times("out");
  const Result missing = film("plan small.toml --why --out out");
  expect_contains(missing.out, "\n    1: done\n    2: frames/blender/0002.png is missing\n");
  const Result changed = film("plan small.toml --why --out out --set camera.field_of_view=50");
  expect_contains(changed.out, "1-2: camera.field_of_view changed\n");
  EXPECT_THAT(different(times("out"), before), IsEmpty());
  EXPECT_EQ(calls(), "1 2 ");
}

class LongPlan : public Tasks {
 protected:
  void SetUp() override {
    Tasks::SetUp();
    std::string frames = "0";
    for (int k = 1; k < 10000; ++k) frames += ", " + std::to_string(k * 1e-4);
    const std::string scene = read_file(folder_ / "small.toml");
    const std::string two = "[0.1, 0.8]";
    write("long.toml", std::string(scene).replace(scene.find(two), two.size(), "[" + frames + "]"));
  }

  std::string plan_within_ten_seconds(const std::string& options) const {
    const auto start = std::chrono::steady_clock::now();
    const std::string limit = sanitized ? "" : "ulimit -v 1000000; ";
    const std::chrono::seconds enough(sanitized ? 600 : 10);  // they cost 20 to 30 times the time
    const Result result = shell(limit + command("plan long.toml --renderer blender " + options));
    EXPECT_LT(std::chrono::steady_clock::now() - start, enough);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_LT(result.out.size(), 10000U);
    return result.out;
  }
};

TEST_F(LongPlan, OfTenThousandFramesIsSmallAndQuick) {
  for (const std::string form : {"", "--why", "--json", "--openjd"})
    expect_contains(plan_within_ten_seconds(form),
                    form.empty() ? "10000 of 10000 to do" : "1-10000");
}

TEST_F(LongPlan, OfTenThousandFramesThatWereMadeIsQuick) {
  ASSERT_EQ(film("render long.toml --quiet", "--out out --frames 1").code, 0);
  for (int frame = 2; frame <= 10000; ++frame)
    for (const std::string stage : {"scenes", "blender"}) {
      const std::string number = fmt::format("{:04}", frame);
      fs::copy_file(folder_ / "out/tasks" / (stage + "_0001.json"),
                    folder_ / "out/tasks" / (stage + "_" + number + ".json"));
    }
  expect_contains(plan_within_ten_seconds("--out out --why"), "    1: done\n    2-10000: made for");
  expect_contains(plan_within_ten_seconds("--out out --why --set seed=5"),
                  "    1-10000: seed changed\n");
}

/// Disk that all tasks of a stage are planned to take.
double planned_bytes(const json& plan, const std::string& stage) {
  for (const json& entry : plan.at("stages"))
    if (entry.at("stage") == stage)
      return entry.at("tasks").get<double>() * entry.at("estimate").at("disk_bytes").get<double>();
  return 0.0;
}

double bytes_below(const fs::path& folder) {
  double bytes = 0.0;
  for (const fs::path& file : files_below(folder))
    bytes += static_cast<double>(fs::file_size(folder / file));
  return bytes;
}

// docs/measurements.md says within 30 % for scenes like the examples; here are other grass, and
// levels of our own.
TEST_F(Tasks, DiskIsPlannedBeforeTheFirstRunAsItIsThenTaken) {
  for (const std::string options :
       {"", " --set grass.blades=400", " --set 'grass.levels=[126,30]' --set grass.patch=0.3"}) {
    const std::string line = "small.toml --renderer both --size 480x270 --out out" + options;
    const json before = json::parse(wold("plan --json " + line).out);
    ASSERT_EQ(wold("generate --quiet " + line).code, 0);
    const double texels = bytes_below(folder_ / "out/texels");
    const double scenes =
        bytes_below(folder_ / "out/blender") + bytes_below(folder_ / "out/povray");
    EXPECT_NEAR(planned_bytes(before, "texels") / texels, 1.0, 0.4) << options;
    EXPECT_NEAR(planned_bytes(before, "scenes") / scenes, 1.0, 0.4) << options;
    const json after = json::parse(wold("plan --json " + line).out);
    EXPECT_NEAR(planned_bytes(after, "scenes") / scenes, 1.0, 0.1) << options << "measured";
    fs::remove_all(folder_ / "out");
  }
}

// With memory for what is planned, what is planned is not refused once its scene files are there.
TEST_F(Tasks, MemoryDecidesTheSameBeforeAndAfterGenerate) {
  const auto planned = [&] {
    for (const json& stage : json::parse(wold("plan small.toml --json --out out").out).at("stages"))
      if (stage.at("stage") == "blender")
        return stage.at("estimate").at("memory_bytes").get<double>();
    return 0.0;
  };
  const double before = planned();
  ASSERT_EQ(wold("generate small.toml --quiet --out out").code, 0);
  EXPECT_EQ(planned(), before);
}

/// "1-2,4" as 1, 2, 4.
std::vector<int> numbers(const std::string& ranges) {
  std::vector<int> all;
  std::istringstream list(ranges);
  for (std::string range; std::getline(list, range, ',');) {
    const int first = std::stoi(range);
    const std::size_t dash = range.find('-');
    const int last = dash == std::string::npos ? first : std::stoi(range.substr(dash + 1));
    for (int number = first; number <= last; ++number) all.push_back(number);
  }
  return all;
}

// Run by the letter of the specification, step by step.
TEST_F(Tasks, TheOpenJobDescriptionMakesTheFilm) {
  const Result result = film("plan small.toml --openjd", "--out farm --frames 1,2");
  ASSERT_EQ(result.code, 0) << result.err;
  const json job = json::parse(result.out);
  EXPECT_EQ(job.at("specificationVersion"), "jobtemplate-2023-09");
  // Defaults may not lead out of the template's directory.
  for (const std::string out : {"/tmp/elsewhere", "./../elsewhere", "in/../../elsewhere"}) {
    const json template_for = json::parse(wold("plan small.toml --openjd --out " + out).out);
    const json& parameters = template_for.at("parameterDefinitions");
    EXPECT_EQ(parameters.at(0).at("default"), "small.toml");
    EXPECT_FALSE(parameters.at(1).contains("default")) << out;
  }
  std::map<std::string, std::string> values;
  for (const json& parameter : job.at("parameterDefinitions"))
    values["{{Param." + parameter.at("name").get<std::string>() + "}}"] = parameter.at("default");
  std::set<std::string> done;
  for (const json& step : job.at("steps")) {
    for (const json& before : step.value("dependencies", json::array()))
      EXPECT_TRUE(done.contains(before.at("dependsOn"))) << step;
    std::vector<int> indices = {0};
    if (step.contains("parameterSpace"))
      indices = numbers(step["parameterSpace"]["taskParameterDefinitions"][0].at("range"));
    const json& action = step.at("script").at("actions").at("onRun");
    EXPECT_EQ(action.at("command"), "wold");
    for (const int index : indices) {
      values["{{Task.Param.Index}}"] = std::to_string(index);
      std::string arguments;
      for (const std::string argument : action.at("args"))
        arguments += " '" + (values.contains(argument) ? values[argument] : argument) + "'";
      const Result task = wold(arguments, blender_played_by(play));
      EXPECT_EQ(task.code, 0) << arguments << task.err;
    }
    done.insert(step.at("name"));
  }
  EXPECT_EQ(calls(), "1 2 ");
  render("local");
  EXPECT_THAT(different(listed("farm"), listed("local")), IsEmpty());
}

class TwoAtOnce : public Tasks {
 protected:
  /// Renders with a script that counts how many of it are at work; the largest number seen.
  int max_at_work(const std::string& options) const {
    const std::string script = blender_played_by(
        "mkdir busy_$frame; n=0\n"
        "while [ $n -lt 20 ]; do ls -d busy_* | wc -l >> seen; sleep 0.1; n=$((n+1)); done\n"
        "rmdir busy_$frame; cp $good \"$out\"");
    const Result result =
        wold("render small.toml --renderer blender --quiet --out out " + options, script);
    EXPECT_EQ(result.code, 0) << result.err;
    std::istringstream seen(read_file(folder_ / "seen"));
    int max = 0;
    for (int count = 0; seen >> count;) max = std::max(max, count);
    fs::remove(folder_ / "seen");
    fs::remove_all(folder_ / "out");
    return max;
  }
};

TEST_F(TwoAtOnce, PicturesWhereThereAreThreadsAndMemory) {
  if (sanitized) GTEST_SKIP() << "sanitized: limits of memory are not tested";
  EXPECT_EQ(max_at_work("--threads 8 --memory 8G"), 2);
  EXPECT_EQ(max_at_work("--threads 4 --memory 8G"), 1);
  EXPECT_EQ(max_at_work("--threads 8 --memory 1600M"), 1);
}

TEST_F(TwoAtOnce, TheSecondRenderOfAFolderWaitsForTheFirst) {
  write("go", "");
  const std::string script =
      blender_played_by("touch started; while [ -e go ]; do sleep 0.1; done; cp $good \"$out\"");
  const std::string line =
      command("render small.toml --renderer blender --quiet --out out", script);
  Running first(folder_, line);
  ASSERT_TRUE(eventually([&] { return fs::exists(folder_ / "started"); }));
  make_folder(folder_ / "second");
  Running second(folder_ / "second", "cd .. && " + line);
  ASSERT_TRUE(eventually([&] { return !second.messages().empty(); }));
  expect_contains(second.messages(), "out is in use by process ");
  fs::remove(folder_ / "go");
  EXPECT_EQ(first.finish().code, 0);
  EXPECT_EQ(second.finish().code, 0);
  EXPECT_EQ(calls(), "1 2 ") << "no frame twice";
  expect_nothing_half_written("out");
  EXPECT_FALSE(fs::exists(folder_ / "out/tasks/lock"));
}

}  // namespace
}  // namespace wold::test
