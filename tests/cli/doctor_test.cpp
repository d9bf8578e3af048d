#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "small_film.h"

/// What `wold doctor` says of programs that it is given.
namespace wold::test {
namespace {

using nlohmann::json;

class Doctor : public SmallFilm {
 protected:
  /// Without the machine's own programs on the PATH.
  Result doctor(const std::string& environment, const std::string& options = "") const {
    return wold("doctor " + options, environment + " PATH=" + quoted((folder_ / "bin").string()));
  }
  /// A script that says its name on the PATH, by tools that it names itself.
  std::string on_path(const std::string& name, const FakeBlender& fake) const {
    fs::create_directory(folder_ / "bin");
    write("bin/" + name, fake_blender_head((folder_ / "probes").string(), fake));
    fs::permissions(folder_ / "bin" / name, fs::perms::owner_all);
    return (folder_ / "bin" / name).string();
  }
  std::string cache() const { return "XDG_CACHE_HOME=" + quoted((folder_ / ".cache").string()); }
};

TEST_F(Doctor, SaysAsJsonWhatEachRendererCan) {
  const std::string blender =
      blender_played_by("", {"5.2.2", true, true, R"([{"type": "CUDA", "name": "Card"}])"});
  const Result result = doctor(blender, "--json");
  EXPECT_EQ(result.code, 0) << result.err;
  const json got = json::parse(result.out);
  EXPECT_EQ(got.at("version"), 1);
  EXPECT_EQ(got.at("complete"), true);
  ASSERT_EQ(got.at("renderers").size(), 2U);
  const json& first = got.at("renderers")[0];
  EXPECT_EQ(first.at("renderer"), "blender");
  EXPECT_EQ(first.at("state"), "complete");
  EXPECT_EQ(first.at("program"), (folder_ / "fake.sh").string());
  EXPECT_EQ(first.at("chosen_by"), "WOLD_BLENDER");
  EXPECT_EQ(first.at("version"), "5.2.2");
  EXPECT_EQ(first.at("module"), false);
  EXPECT_EQ(first.at("problem"), nullptr);
  EXPECT_EQ(first.at("capabilities"), json::parse(R"({
    "version": "5.2.2", "python": "3.99", "volumes": true, "fog": true, "nanovdb": null,
    "devices": [{"type": "CUDA", "name": "Card"}], "threads": 2})"));
  const json& second = got.at("renderers")[1];
  EXPECT_EQ(second.at("renderer"), "povray");
  EXPECT_EQ(second.at("state"), "missing");
  EXPECT_EQ(second.at("program"), nullptr);
  EXPECT_EQ(second.at("capabilities"), nullptr);
  expect_contains(second.at("problem"), "apt-get install povray");
  EXPECT_EQ(got.at("other_blenders"), json::array());
  EXPECT_EQ(got.at("ffmpeg"), nullptr);
}

TEST_F(Doctor, WithoutAnyRendererThatShowsEverythingIsExitCodeThree) {
  const Result none = doctor(cache());
  EXPECT_EQ(none.code, 3);
  expect_contains(none.out, "Blender: missing\n");
  expect_contains(none.out, "apt-get install blender");
  expect_contains(none.out, "FFmpeg: missing\n");
  const Result lacking = doctor(blender_played_by("", {"5.2.2", false, true, "[]"}));
  EXPECT_EQ(lacking.code, 3);
  expect_contains(lacking.out, "Blender 5.2.2 (" + (folder_ / "fake.sh").string() +
                                   "), named by WOLD_BLENDER: it does not show everything\n");
  expect_contains(lacking.out, "volumes   no        it shows neither grass as texels");
  const Result other = doctor(cache(), "--blender /bin/echo --json");
  EXPECT_EQ(other.code, 3);
  EXPECT_EQ(json::parse(other.out).at("renderers")[0].at("state"), "unknown");
}

TEST_F(Doctor, ListsOtherBlendersOnThePathOnce) {
  const std::string newer = on_path("blender-5.2", {"5.2.2", true, true, "[]"});
  on_path("blender", {"3.4.1", true, true, "[]"});
  on_path("blender-thumbnailer", {"1.0.0", true, true, "[]"});
  fs::create_symlink(newer, folder_ / "bin/blender5");
  const Result result = doctor(cache(), "--json");
  const json got = json::parse(result.out);
  EXPECT_EQ(got.at("renderers")[0].at("chosen_by"), "PATH");
  EXPECT_EQ(got.at("renderers")[0].at("version"), "3.4.1");
  EXPECT_EQ(got.at("other_blenders"), json::array({{{"program", newer}, {"version", "5.2.2"}}}));
}

TEST_F(Doctor, ProbesAnewAndRenderTakesItFromThere) {
  const std::string blender = blender_played_by("cp $good \"$out\"");
  const auto probes = [&] { return shell("wc -l < probes").out; };
  doctor(blender);
  EXPECT_EQ(probes(), "1\n");
  doctor(blender);
  EXPECT_EQ(probes(), "2\n");
  EXPECT_EQ(wold("render small.toml --quiet --renderer blender --out out", blender).code, 0);
  EXPECT_EQ(probes(), "2\n");
}

}  // namespace
}  // namespace wold::test
