#include <gmock/gmock.h>

#include <chrono>

#include "core/files.h"
#include "small_film.h"

/// What a renderer can show is asked before anything is made, once, and only when it matters.
namespace wold::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class Probed : public SmallFilm {
 protected:
  static constexpr const char* play = "cp $good \"$out\"";
  static constexpr FakeBlender without_volumes = {"5.2.2", false, true, "[]"};

  Result render(const FakeBlender& fake = {}, const std::string& options = "") const {
    return wold("render small.toml --quiet --renderer blender --out out " + options,
                blender_played_by(play, fake));
  }
  /// How often Blender was probed since the last time.
  std::size_t probes() const {
    const fs::path file = folder_ / "probes";
    const std::string lines = fs::exists(file) ? read_file(file) : "";
    fs::remove(file);
    return static_cast<std::size_t>(std::ranges::count(lines, '\n'));
  }
  void expect_refused(const Result& result, const std::string& part) const {
    EXPECT_EQ(result.code, 3);
    EXPECT_EQ(result.out, "");
    expect_contains(result.err, part);
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << "one sentence: " << result.err;
    EXPECT_EQ(calls(), "");
  }
};

TEST_F(Probed, ABlenderWithoutVolumesIsRefusedInOneSentenceAndNothingIsMade) {
  const auto start = std::chrono::steady_clock::now();
  const Result result = render(without_volumes);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  expect_refused(result, "Blender 5.2.2 (" + (folder_ / "fake.sh").string() + ") shows no volumes");
  expect_contains(result.err, "this scene's grass");
  expect_contains(result.err, "--blender or WOLD_BLENDER");
  expect_contains(result.err, "pip install bpy");
  expect_contains(result.err, "--grass blades");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Probed, WithOneRendererRefusedTheOtherDoesNothingEither) {
  write("povray.sh", "#!/bin/sh\ncase \"$1\" in --version) echo 'POV-Ray 3.7' ;; *) touch '" +
                         (folder_ / "started").string() + "' ;; esac\n");
  fs::permissions(folder_ / "povray.sh", fs::perms::owner_all);
  const Result result =
      wold("render small.toml --quiet --renderer both --out out --povray ./povray.sh",
           blender_played_by(play, without_volumes));
  expect_refused(result, "shows no volumes");
  EXPECT_FALSE(fs::exists(folder_ / "started"));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Probed, WhatTheSceneDoesNotNeedIsNotAskedFor) {
  const Result blades = render(without_volumes, "--grass blades");
  EXPECT_EQ(blades.code, 0) << blades.err;
  EXPECT_EQ(calls(), "1 2 ");
  EXPECT_EQ(probes(), 0U);
  expect_refused(render(without_volumes, "--grass auto"), "shows no volumes");
  write("clouds.toml",
        read_file(folder_ / "small.toml") +
            "grass = \"blades\"\n[[clouds]]\nkind = \"cumulus\"\nbody = \"volume\"\n");
  const Result clouds = wold("render clouds.toml --quiet --renderer blender --out clouds",
                             blender_played_by(play, without_volumes));
  expect_refused(clouds, "this scene's clouds would be drawn as");
  EXPECT_THAT(clouds.err, Not(HasSubstr("--grass blades")));
  expect_contains(clouds.err, "body = \"sheet\"");
}

TEST_F(Probed, FogIsNeededWhereItMaySnow) {
  const FakeBlender clear = {"9.9.9", true, false, "[]"};
  EXPECT_EQ(render(clear).code, 0);
  calls();
  expect_refused(render(clear, "--set weather.precipitation=1"), "shows no homogeneous medium");
}

TEST_F(Probed, OnceForManyPicturesAndRuns) {
  const std::string blender = blender_played_by(play);
  const std::string line = "render small.toml --quiet --renderer blender --out ";
  EXPECT_EQ(wold(line + "out", blender).code, 0);
  EXPECT_EQ(wold(line + "out --set camera.field_of_view=50", blender).code, 0);
  EXPECT_EQ(wold(line + "other", blender).code, 0);
  EXPECT_EQ(calls(), "1 2 1 2 1 2 ");
  EXPECT_EQ(probes(), 1U);
}

TEST_F(Probed, NotWhereNothingIsToBeRendered) {
  const std::string blender = blender_played_by(play);
  const std::string options = " small.toml --quiet --renderer blender --out out ";
  EXPECT_EQ(wold("generate" + options, blender).code, 0);
  EXPECT_EQ(wold("plan small.toml --renderer blender --out out", blender).code, 0);
  EXPECT_EQ(wold("render --dry-run" + options, blender).code, 0);
  EXPECT_EQ(wold("task small.toml scenes 1 --quiet --renderer blender --out out", blender).code, 0);
  EXPECT_EQ(probes(), 0U);
  EXPECT_EQ(wold("render" + options, blender).code, 0);
  EXPECT_EQ(probes(), 1U);
  fs::remove_all(folder_ / ".cache");
  EXPECT_EQ(wold("render" + options, blender).code, 0);
  EXPECT_EQ(wold("render" + options, "WOLD_BLENDER=/nowhere").code, 0) << "all is there";
  EXPECT_EQ(probes(), 0U);
}

TEST_F(Probed, ARefusalIsNotKept) {
  const std::string line = "render small.toml --quiet --renderer blender --out out";
  const std::string blender = blender_played_by(play, without_volumes);
  EXPECT_EQ(wold(line, blender).code, 3);
  EXPECT_EQ(wold(line, blender).code, 3);
  EXPECT_EQ(probes(), 2U) << "a library may have been installed since then";
}

TEST_F(Probed, ATaskOfPicturesToo) {
  const std::string blender = blender_played_by(play, without_volumes);
  expect_refused(wold("task small.toml --quiet --out fresh --renderer blender blender 1", blender),
                 "shows no volumes");
  EXPECT_FALSE(fs::exists(folder_ / "fresh"));
  for (const char* task : {"texels 1", "texels 2", "scenes 1"})
    EXPECT_EQ(
        wold("task small.toml --quiet --out out --renderer blender " + std::string(task), blender)
            .code,
        0);
  expect_refused(wold("task small.toml --quiet --out out --renderer blender blender 1", blender),
                 "shows no volumes");
}

TEST_F(Probed, WhoDoesNotAnswerIsNamed) {
  write("mute.sh", "#!/bin/sh\n[ \"$1\" = --version ] && echo 'Blender 2.79' || exit 9\n");
  fs::permissions(folder_ / "mute.sh", fs::perms::owner_all);
  const Result result = wold("render small.toml --quiet --renderer blender --blender ./mute.sh");
  EXPECT_EQ(result.code, 3);
  expect_contains(result.err, "Blender 2.79");
  expect_contains(result.err, "does not say what it can show: exit code 9");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Probed, TheOptionIsStrongerThanTheVariable) {
  blender_played_by(play);
  fs::rename(folder_ / "fake.sh", folder_ / "chosen.sh");
  const std::string refusing = blender_played_by(play, without_volumes);
  const std::string options = "render small.toml --quiet --renderer blender --out out ";
  EXPECT_EQ(wold(options, refusing).code, 3);
  const Result result = wold(options + "--blender ./chosen.sh", refusing);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(calls(), "1 2 ");
  const Result plan =
      wold("plan small.toml --openjd --out out --blender my-blender --povray my-povray");
  expect_contains(plan.out, "\"--blender\",");
  expect_contains(plan.out, "\"my-blender\"");
  expect_contains(plan.out, "\"my-povray\"");
}

constexpr FakeBlender with_card = {"9.9.9", true, true,
                                   "[{\"type\": \"OPTIX\", \"name\": \"Card\"}]"};

TEST_F(Probed, ADeviceThatIsNotThereIsRefusedOrLeftOut) {
  const Result none = render({}, "--set render.device=gpu --grass blades");
  expect_refused(none, "finds no graphics card");
  expect_contains(none.err, "render.device to \"cpu\" or \"auto\"");
  const Result chosen = render({}, "--set render.device=auto");
  EXPECT_EQ(chosen.code, 0);
  expect_contains(chosen.err, "takes the processor");
  EXPECT_EQ(calls(), "1 2 ");
  fs::remove_all(folder_ / "out");
  const Result card = render(with_card, "--set render.device=auto");
  EXPECT_EQ(card.code, 0);
  EXPECT_EQ(card.err, "");
  expect_contains(read_file(folder_ / "out/logs/blender_0001.log"), " --device auto\n");
}

TEST_F(Probed, AnotherDeviceMakesBlendersPicturesAnewAndNothingElse) {
  EXPECT_EQ(render(with_card).code, 0);
  calls();
  const auto before = times("out");
  EXPECT_EQ(render(with_card, "--set render.device=gpu").code, 0);
  EXPECT_EQ(calls(), "1 2 ");
  for (const std::string& changed : different(times("out"), before))
    EXPECT_THAT(changed, testing::AnyOf(HasSubstr("frames/blender"), HasSubstr("logs/"),
                                        HasSubstr("tasks/blender"), HasSubstr("scene.toml"),
                                        HasSubstr("manifest.json"), HasSubstr("tasks/lock")));
}

}  // namespace
}  // namespace wold::test
