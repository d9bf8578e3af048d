#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "core/files.h"
#include "support/sanitized.h"
#include "tiny_film.h"

/// --memory is kept, or refused before anything is done.
namespace wold::test {
namespace {

class Memory : public SmallFilm {
 protected:
  void SetUp() override {
    SmallFilm::SetUp();
    if (sanitized) GTEST_SKIP() << "sanitized: limits of memory are not tested";
  }

  static constexpr const char* render =
      "render small.toml --renderer blender --quiet --out out --threads 8 --memory ";

  /// What `plan` says that a task of the stage takes, MB.
  double planned_mb(const std::string& stage, const std::string& options = "--threads 8") const {
    const Result result = wold("plan small.toml --renderer blender --json --out out " + options);
    const auto plan = nlohmann::json::parse(result.out);
    for (const auto& entry : plan.at("stages"))
      if (entry.at("stage") == stage)
        return entry.at("estimate").at("memory_bytes").get<double>() / 1e6;
    return 0.0;
  }
};

TEST_F(Memory, TooLittleIsRefusedBeforeAnythingIsWritten) {
  const Result result = wold(std::string(render) + "200M", blender_played_by("cp $good \"$out\""));
  EXPECT_EQ(result.code, 2);
  expect_contains(result.err, "--memory: found 200M, expected about ");
  expect_contains(result.err, "for the tasks \"blender\"");
  EXPECT_EQ(calls(), "");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

// The limits are the system's own: whatever the programs do, they get no more together.
TEST_F(Memory, LimitsOfAllProcessesTogetherAreWhatWasAllowed) {
  const std::string script = blender_played_by(
      "ulimit -S -d > renderer_kb_$frame\n"
      "awk '/Max data size/ {print $4}' /proc/$PPID/limits > wold_bytes\n"
      "mkdir busy_$frame; n=0\n"
      "while [ $n -lt 20 ]; do ls -d busy_* | wc -l >> seen; sleep 0.1; n=$((n+1)); done\n"
      "rmdir busy_$frame; cp $good \"$out\"");
  const auto number = [&](const std::string& file) { return std::stod(read_file(folder_ / file)); };
  const Result result = wold(std::string(render) + "4G", script);
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_THAT(read_file(folder_ / "seen"), testing::HasSubstr("2")) << "none at the same time";
  const double together =
      number("wold_bytes") + 1024.0 * (number("renderer_kb_1") + number("renderer_kb_2"));
  constexpr double allowed = 4.0 * (1 << 30);
  EXPECT_LE(together, allowed);
  EXPECT_GE(together, 0.99 * allowed) << "some of it is not used";
  EXPECT_GE(1024.0 * number("renderer_kb_1"), planned_mb("blender") * 1e6);
}

TEST_F(Memory, OfARendererIsRememberedForItsNextPictures) {
  const double guessed_mb = planned_mb("blender");
  const std::string script = blender_played_by(
      "x=$(head -c 30000000 /dev/zero | tr '\\0' x); sleep 0.5; cp $good \"$out\"");
  ASSERT_EQ(wold("render small.toml --renderer blender --quiet --out out", script).code, 0);
  EXPECT_GT(planned_mb("blender"), 30.0);
  EXPECT_LT(planned_mb("blender"), guessed_mb);
}

// Memory may end anywhere in the work, once the libraries have started, and in their threads, too,
// where nobody can catch it. Without --memory nothing is refused.
TEST_F(Memory, ThatRunsOutAnywhereLeavesNothingHalfMade) {
  const std::string generate =
      command("generate small.toml --renderer povray --quiet --threads 2 --out ");
  const auto with_mb = [&](int limit_mb, const std::string& line) {
    return shell(fmt::format("ulimit -S -d {}; {}", limit_mb * 1000, line));
  };
  int start_mb = 60;  // what libraries need differs from system to system
  while (start_mb < 600 && with_mb(start_mb, command("explain terrain.size")).code != 0)
    start_mb += 4;
  int failed = 0;
  for (int limit_mb = start_mb + 4; limit_mb < start_mb + 200; limit_mb += 8) {
    SCOPED_TRACE(limit_mb);
    const Result result = with_mb(limit_mb, generate + " out");
    if (result.code == 0) break;
    ++failed;
    EXPECT_EQ(result.code, 4) << result.err;
    expect_contains(result.err, "error: ");
    expect_nothing_half_written("out");
  }
  EXPECT_GE(failed, 3);
  for (const char* out : {" out", " undisturbed"}) ASSERT_EQ(shell(generate + out).code, 0);
  EXPECT_THAT(different(contents("out"), contents("undisturbed")), testing::IsEmpty());
}

// The ground's picture grows with the scene's.
TEST_F(Memory, PlannedForALargePictureIsEnough) {
  const std::string large = "--threads 2 --size 1920x108 --set terrain.size=20";
  const double scenes_mb = planned_mb("scenes", large);
  EXPECT_GT(scenes_mb, planned_mb("scenes", "--threads 2") + 200.0);
  const Result result = shell(
      fmt::format("ulimit -S -d {:.0f}; {}", scenes_mb * 1000.0,
                  command("generate small.toml --renderer blender --quiet --out out " + large)));
  EXPECT_EQ(result.code, 0) << result.err;
}

using TinyFilmsMemory = TinyFilm;

TEST_F(TinyFilmsMemory, WhatARefusalAsksForIsEnough) {
  if (sanitized) GTEST_SKIP() << "sanitized: limits of memory are not tested";
  const std::string render = "render tiny.toml --quiet --out out --memory ";
  const std::string refusal = wold(render + "1M").err;
  const std::regex needs("expected about ([0-9]+)M");
  int max = 0;
  for (std::sregex_iterator need(refusal.begin(), refusal.end(), needs), end; need != end; ++need)
    max = std::max(max, std::stoi((*need)[1]));
  ASSERT_GT(max, 100) << refusal;
  const Result result = wold(render + std::to_string(max) + "M");
  EXPECT_EQ(result.code, 0) << result.err;
  expect_undisturbed("out");
}

}  // namespace
}  // namespace wold::test
