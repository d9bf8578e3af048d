#include <gmock/gmock.h>

#include <array>

#include "core/files.h"
#include "core/image.h"
#include "core/layered_image.h"
#include "program.h"
#include "support/places.h"

namespace wold::test {
namespace {

using Colour = std::array<float, 3>;

/// Films of flat pictures, by FFmpeg itself.
class FilmCommand : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    if (!is_installed("ffmpeg") || !is_installed("ffprobe"))
      GTEST_SKIP() << "no ffmpeg on this machine";
  }

  fs::path frame(int number, const std::string& renderer = "povray") const {
    return folder_ / "d/frames" / renderer / ("000" + std::to_string(number) + ".png");
  }

  void draw(const fs::path& picture, const Colour& colour, int width = 64, int height = 36) const {
    Image image(width, height, 3);
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = colour[i % 3];
    make_folder(picture.parent_path());
    write_image(picture, image, PixelFormat::uint8);
  }

  std::string bytes(const std::string& name) const { return read_file(folder_ / name); }
  bool exists(const std::string& name) const { return fs::exists(folder_ / name); }
};

int count_of(const std::string& part, const std::string& text) {
  int count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

TEST_F(FilmCommand, ShowsEveryFrameInItsColoursForItsTimeAndLoops) {
  const std::vector<Colour> colours = {
      {0.25F, 0.5F, 0.125F}, {0.875F, 0.125F, 0.125F}, {0.75F, 0.625F, 0.25F}};
  for (int i = 0; i < 3; ++i) draw(frame(i + 1), colours[static_cast<std::size_t>(i)], 65, 37);
  const Result made = wold("film d --fps 8 --quiet");
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.out, "d/film_povray.mp4\nd/film_povray.webp\n");
  EXPECT_EQ(made.err, "");

  const Result probed = shell(
      "ffprobe -v error -count_frames -show_entries "
      "stream=codec_name,width,height,pix_fmt,r_frame_rate,nb_read_frames -of csv=p=0 "
      "d/film_povray.mp4");
  EXPECT_EQ(probed.out, "h264,66,38,yuv420p,8/1,3\n");  // yuv420p has even sizes only
  ASSERT_EQ(shell("ffmpeg -v error -i d/film_povray.mp4 seen%d.png").code, 0);
  for (int i = 0; i < 3; ++i) {
    const Image seen = read_image(folder_ / ("seen" + std::to_string(i + 1) + ".png"));
    for (const auto& [x, y] :
         {std::pair{30, 20}, std::pair{65, 37}})  // and the edge that was added
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(seen.pixel(x, y)[c],
                    colours[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)], 4.0 / 255.0)
            << "frame " << i + 1 << ", channel " << c << " at " << x << ", " << y;
  }
  const std::string mp4 = bytes("d/film_povray.mp4");
  EXPECT_LT(mp4.find("moov"), mp4.find("mdat"));  // starts before it has all arrived

  // WebP container specification: ANIM has 4 bytes of colour, then how often it loops, 0 for ever.
  const std::string webp = bytes("d/film_povray.webp");
  EXPECT_EQ(count_of("ANMF", webp), 3);
  const std::size_t anim = webp.find("ANIM");
  ASSERT_NE(anim, std::string::npos);
  EXPECT_EQ(webp.substr(anim + 12, 2), std::string(2, '\0'));
}

TEST_F(FilmCommand, SaysThatAFilmIsOverAtOnce) {
  for (int i = 1; i <= 3; ++i) draw(frame(i), {0.25F, 0.5F, 0.125F}, 64, 36);
  expect_contains(wold("film d").err, "warning: d/film_povray.mp4 lasts 0.12 s: 3 frames at 24 a");
  EXPECT_EQ(wold("film d --fps 24 --quiet").err, "");
}

TEST_F(FilmCommand, IsTheSameBytesEachTime) {
  for (int i = 1; i <= 3; ++i)
    draw(frame(i), {0.25F * static_cast<float>(i), 0.5F, 0.25F}, 320, 180);
  ASSERT_EQ(wold("film d").code, 0);
  const std::string mp4 = bytes("d/film_povray.mp4");
  const std::string webp = bytes("d/film_povray.webp");
  ASSERT_EQ(
      shell("taskset -c 0 env '" + wold_program().string() + "' film d --out e/other.mp4").code, 0);
  EXPECT_EQ(bytes("e/other.mp4"), mp4);
  EXPECT_EQ(bytes("e/other.webp"), webp);
}

TEST_F(FilmCommand, MissingFramesAreNamedAndSomeCanBeTaken) {
  for (const int i : {1, 2, 4}) draw(frame(i), {0.5F, 0.5F, 0.25F});
  write("d/scene.toml", "[ageing]\nframes = [0, 0.2, 0.4, 0.6, 0.8, 1]\n");
  const Result gap = wold("film d");
  EXPECT_EQ(gap.code, 4);
  expect_contains(gap.err, "error: frames are missing in d/frames: POV-Ray's 3,5-6;");
  EXPECT_FALSE(exists("d/film_povray.mp4"));
  EXPECT_EQ(wold("film d --frames 1-2").code, 0);
  EXPECT_EQ(wold("film d --frames 1,4").code, 2);
  EXPECT_EQ(wold("film d --frames 2-4").code, 4);
  fs::remove(folder_ / "d/scene.toml");
  EXPECT_EQ(wold("film d").code, 4);  // the pictures themselves have a gap
  draw(frame(3), {0.5F, 0.5F, 0.25F});
  EXPECT_EQ(wold("film d").code, 0);
}

TEST_F(FilmCommand, EachRendererHasAFilmUnlessOneIsAskedFor) {
  for (const std::string renderer : {"blender", "povray"})
    for (const int i : {1, 2}) draw(frame(i, renderer), {0.5F, 0.5F, 0.25F});
  EXPECT_EQ(wold("film d").out,
            "d/film_blender.mp4\nd/film_blender.webp\nd/film_povray.mp4\nd/film_povray.webp\n");
  EXPECT_EQ(wold("film d --renderer povray --out one.mp4").out, "one.mp4\none.webp\n");
  fs::remove(frame(2, "blender"));
  EXPECT_EQ(wold("film d").out, "d/film_povray.mp4\nd/film_povray.webp\n");
  EXPECT_EQ(wold("film d --renderer blender").code, 4);
  EXPECT_EQ(wold("film nowhere").code, 4);
  EXPECT_EQ(wold("film d --out film.avi").code, 2);
  EXPECT_EQ(wold("film d --fps nan").code, 2);
}

TEST_F(FilmCommand, NothingHalfDoneIsLeft) {
  for (int i = 1; i <= 3; ++i) draw(frame(i), {0.5F, 0.125F * static_cast<float>(i), 0.25F});
  ASSERT_EQ(wold("film d").code, 0);
  const std::string before = bytes("d/film_povray.mp4");
  fs::resize_file(frame(2), fs::file_size(frame(2)) - 40);
  const Result damaged = wold("film d");
  EXPECT_EQ(damaged.code, 3);
  expect_contains(damaged.err, "d/logs/film_povray_mp4.log");
  EXPECT_EQ(bytes("d/film_povray.mp4"), before);
  draw(frame(2), {0.5F, 0.5F, 0.5F}, 32, 18);
  const Result other_size = wold("film d");
  EXPECT_EQ(other_size.code, 4);
  expect_contains(other_size.err, "0002.png has 32 x 18 pixels, expected 64 x 36");
  const Result no_ffmpeg = wold("film d --frames 1", "WOLD_FFMPEG=/nowhere/ffmpeg");
  EXPECT_EQ(no_ffmpeg.code, 3);
  expect_contains(no_ffmpeg.err, "apt-get install ffmpeg");
  for (const auto& entry : fs::directory_iterator(folder_ / "d"))
    EXPECT_NE(entry.path().filename().string().front(), '.') << entry;
}

/// A grey bar that goes 16 pixels to the right in each frame, before black that stands still.
class MovingBar : public FilmCommand {
 protected:
  static constexpr int width = 96, height = 36, motion_px = 16;

  void SetUp() override {
    FilmCommand::SetUp();
    for (const int number : {1, 2}) {
      draw_bar(number);
      write_passes(number, width, height);
    }
  }
  static bool is_bar(int number, int x) { return x >= 16 * number && x < 16 * number + 32; }
  void draw_bar(int number) const {
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        std::fill_n(image.pixel(x, y), 3, is_bar(number, x) ? 0.5F : 0.0F);
    make_folder(frame(number).parent_path());
    write_image(frame(number), image, PixelFormat::uint8);
  }
  void write_passes(int number, int columns, int rows) const {
    LayeredImage passes{columns, rows, {}, {}};
    const auto add = [&](const std::string& name, float of_bar, float of_rest) {
      ImageChannel channel{name, PixelFormat::float32, {}};
      for (int i = 0; i < columns * rows; ++i)
        channel.values.push_back(is_bar(number, i % columns) ? of_bar : of_rest);
      passes.channels.push_back(channel);
    };
    add("motion.X", motion_px, 0.0F);
    add("motion.Y", 0.0F, 0.0F);
    add("depth.Z", 3.0F, 1e10F);
    write_layered_image(passes_file(number), passes);
  }
  fs::path passes_file(int number) const {
    const fs::path file = folder_ / "d/passes" / ("000" + std::to_string(number) + ".exr");
    make_folder(file.parent_path());
    return file;
  }
};

// Light adds up: 0.5 is a light of 0.214, and a pixel that has it half of the time is 0.36, not
// 0.25.
TEST_F(MovingBar, IsBlurredAsLongAsTheShutterIsOpen) {
  const Result made = wold("film d --shutter 0.5 --quiet");
  ASSERT_EQ(made.code, 0) << made.err;
  ASSERT_EQ(shell("ffmpeg -v error -i d/film_povray.mp4 seen%d.png").code, 0);
  for (const int number : {1, 2}) {
    const Image seen = read_image(folder_ / ("seen" + std::to_string(number) + ".png"));
    const int edge = 16 * number;
    EXPECT_LT(seen.pixel(edge - 7, 18)[1], 0.04F);
    EXPECT_NEAR(seen.pixel(edge - 2, 18)[1], 0.287F, 0.04F);  // 5 of 16 moments
    EXPECT_NEAR(seen.pixel(edge + 1, 18)[1], 0.420F, 0.04F);  // 11 of 16
    EXPECT_NEAR(seen.pixel(edge + 8, 18)[1], 0.5F, 0.04F);
  }
  const std::string blurred = bytes("d/film_povray.mp4");
  ASSERT_EQ(wold("film d").code, 0);
  EXPECT_NE(bytes("d/film_povray.mp4"), blurred);
  write("d/scene.toml", "[ageing]\nframes = [0, 0.2]\n[film]\nshutter = 0.5\n");
  ASSERT_EQ(wold("film d").code, 0);
  EXPECT_EQ(bytes("d/film_povray.mp4"), blurred);
  ASSERT_EQ(wold("film d --shutter 0").code, 0);
  EXPECT_NE(bytes("d/film_povray.mp4"), blurred);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "d/frames/povray"), {}), 2);
}

TEST_F(MovingBar, PassesThatAreMissingOrOthersAreNamed) {
  write_passes(2, width / 2, height);
  const Result other_size = wold("film d --shutter 0.5");
  EXPECT_EQ(other_size.code, 4);
  expect_contains(other_size.err, "d/passes/0002.exr has 48 x 36 pixels, expected 96 x 36");
  fs::remove(passes_file(2));
  const Result missing = wold("film d --shutter 0.5");
  EXPECT_EQ(missing.code, 4);
  expect_contains(missing.err,
                  "found no d/passes/0002.exr, expected passes for the blur of frames 2; `wold "
                  "passes d/scene.toml --passes depth,motion --out d`");
  EXPECT_EQ(wold("film d --shutter 1.5").code, 2);
  EXPECT_FALSE(exists("d/film_povray.mp4"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "d/frames/povray"), {}), 2);
}

TEST_F(FilmCommand, FoldersMayHaveAnyName) {
  draw(frame(1), {0.5F, 0.5F, 0.25F});
  const std::string odd = "-a %04d 'b' $(touch c);http:d\n\xC3\xA9";
  fs::rename(folder_ / "d", folder_ / odd);
  const Result made = wold("film ./" + quoted(odd));
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(fs::exists(folder_ / odd / "film_povray.mp4"));
  EXPECT_FALSE(exists("c"));
}

}  // namespace
}  // namespace wold::test
