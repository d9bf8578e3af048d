#include "render/encode.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "core/error.h"
#include "fake_renderer.h"
#include "support/temporary_folder.h"

namespace wold::test {
namespace {

using ::testing::HasSubstr;

/// A folder with three pictures and a script that plays FFmpeg; in it, $film is the wanted film.
class FakeFfmpeg : public ::testing::Test {
 protected:
  static constexpr int count = 3;

  void SetUp() override { ::setenv("WOLD_FFMPEG", (folder_.path() / "ffmpeg.sh").c_str(), 1); }
  void TearDown() override { ::unsetenv("WOLD_FFMPEG"); }

  void play(const std::string& body) const {
    const fs::path script = folder_.path() / "ffmpeg.sh";
    write_file(script, "#!/bin/sh\nfor film; do :; done\nfilm=${film#file:}\necho \"$@\" > '" +
                           (folder_.path() / "arguments").string() + "'\n" + body + "\n");
    fs::permissions(script, fs::perms::owner_all);
  }

  render::Encoding encoding(glm::ivec2 size_px) const {
    return {.pictures = folder_.path(),
            .first = 1,
            .count = count,
            .size_px = size_px,
            .frames_per_second = 24.0,
            .timeout = std::chrono::seconds(20),
            .film = folder_.path() / "film.mp4",
            .log = folder_.path() / "film.log"};
  }

  void encode(glm::ivec2 size_px = {32, 18}) const {
    SilentProgress progress;
    render::encode(encoding(size_px), progress, [] { return false; });
  }

  std::string arguments() const { return read_file(folder_.path() / "arguments"); }

  TemporaryFolder folder_{"encode"};
};

TEST_F(FakeFfmpeg, FilmThatEndsEarlyOrLateIsNone) {
  for (const int frames : {0, 2, 4}) {
    play("echo frame=" + std::to_string(frames) + "; echo made > \"$film\"");
    try {
      encode();
      ADD_FAILURE() << frames << " frames were taken";
    } catch (const RendererError& error) {
      EXPECT_THAT(error.what(),
                  HasSubstr("found " + std::to_string(frames) + " frames in the film, expected 3"));
    }
    EXPECT_FALSE(fs::exists(encoding({32, 18}).film));
  }
  play("echo frame=1; echo frame=3; echo made > \"$film\"");
  encode();
  EXPECT_EQ(read_file(encoding({32, 18}).film), "made\n");
}

// yuv420p has even sizes only; what is even stays.
TEST_F(FakeFfmpeg, OddSizesAreFilledUpAndEvenOnesStay) {
  play("echo frame=3; echo made > \"$film\"");
  encode({31, 18});
  EXPECT_THAT(arguments(), HasSubstr("pad=32:18,fillborders=right=1:bottom=0:mode=smear,"));
  encode({32, 17});
  EXPECT_THAT(arguments(), HasSubstr("pad=32:18,fillborders=right=0:bottom=1:mode=smear,"));
  encode({32, 18});
  EXPECT_THAT(arguments(), ::testing::Not(HasSubstr("pad=")));
}

}  // namespace
}  // namespace wold::test
