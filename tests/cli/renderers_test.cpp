#include <csignal>
#include <cstdlib>

#include "core/files.h"
#include "core/image.h"
#include "small_film.h"

/// The small film in Blender and POV-Ray themselves. Skipped where one is missing.
namespace wold::test {
namespace {

class Renderers : public SmallFilm, public testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    SmallFilm::SetUp();
    if (!can_render(GetParam()))
      GTEST_SKIP() << "no complete " << GetParam()
                   << " on this machine: its pictures are not tested";
  }

  std::string render(const std::string& out, const std::string& options = "") const {
    return "render small.toml --renderer " + GetParam() + " --out " + out + " " + options;
  }
  std::string picture(const std::string& out, int frame) const {
    return out + "/frames/" + GetParam() + "/000" + std::to_string(frame) + ".png";
  }

  void expect_equal_pictures(const std::string& got, const std::string& want) const {
    const Result result =
        wold("compare '" + got + "' '" + want + "' --rmse 0 --soft 0 --share 0 --hard 0");
    EXPECT_EQ(result.code, 0) << result.out << result.err;
  }
};

TEST_P(Renderers, PicturesAreTheSameAloneTogetherAndWithAnyNumberOfThreads) {
  ASSERT_EQ(wold(render("out", "--threads 2")).code, 0);
  ASSERT_EQ(wold(render("alone", "--frames 2 --threads 1")).code, 0);
  EXPECT_FALSE(fs::exists(folder_ / picture("alone", 1)));
  expect_equal_pictures(picture("alone", 2), picture("out", 2));
  EXPECT_EQ(read_file(folder_ / picture("alone", 2)), read_file(folder_ / picture("out", 2)))
      << "the same pixels, but other bytes";
}

TEST_P(Renderers, TheExportedFolderWorksElsewhereWithoutWold) {
  const Result made = wold(render("out"));
  ASSERT_EQ(made.code, 0) << made.err;
  const fs::path elsewhere = folder_ / "another place";
  fs::copy(folder_ / "out" / GetParam(), elsewhere, fs::copy_options::recursive);
  fs::rename(folder_ / "out", folder_ / "kept");  // nothing may be read from where it was made
  const bool is_blender = GetParam() == "blender";
  ASSERT_EQ(wold("extension --out package").code, 0);
  const std::string command =
      is_blender ? "blender -b --python-exit-code 1 -P ../package/wold_render.py -- . 1"
                 : "povray scene.pov";
  const Result result = shell("cd 'another place' && " + command);
  ASSERT_EQ(result.code, 0) << result.out << result.err;
  const std::string name = is_blender ? "another place/frame_0001.png" : "another place/scene.png";
  const Image image = read_image(folder_ / name);
  EXPECT_EQ(image.width, 64);
  EXPECT_EQ(image.height, 36);
  expect_equal_pictures(name, picture("kept", 1));
}

TEST_P(Renderers, AnInterruptEndsThem) {
  const std::string variable = GetParam() == "blender" ? "WOLD_BLENDER" : "WOLD_POVRAY";
  write("wrapped.sh",
        "#!/bin/sh\necho $$ > '" + folder_.string() + "/pid'\nexec " + GetParam() + " \"$@\"\n");
  fs::permissions(folder_ / "wrapped.sh", fs::perms::owner_all);
  const std::string slow = render("out", "--frames 1 --size 320x180 --samples 4");
  Running program(folder_,
                  command(slow, variable + "='" + (folder_ / "wrapped.sh").string() + "'"));
  ASSERT_TRUE(
      eventually([&] { return program.messages().find("\npictures ") != std::string::npos; }));
  program.send(SIGINT);
  const Result result = program.finish();
  EXPECT_EQ(result.code, 130) << result.err;
  EXPECT_TRUE(is_gone(folder_ / "pid"));
  EXPECT_FALSE(fs::exists(folder_ / picture("out", 1)));
  EXPECT_TRUE(fs::is_empty((folder_ / picture("out", 1)).parent_path()));
  EXPECT_EQ(wold(slow).code, 0);
  EXPECT_TRUE(fs::exists(folder_ / picture("out", 1)));
}

INSTANTIATE_TEST_SUITE_P(Both, Renderers, testing::Values("blender", "povray"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wold::test
