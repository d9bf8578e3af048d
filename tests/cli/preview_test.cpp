#include <gmock/gmock.h>

#include "core/files.h"
#include "core/image.h"
#include "program.h"
#include "support/places.h"

namespace wold::test {
namespace {

class Preview : public Program {
 protected:
  Image drawn(const std::string& arguments) const {
    const Result result = wold("preview " + arguments + " --out sheet.png");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "sheet.png\n");
    return read_image(folder_ / "sheet.png");
  }
};

/// Mean colour of a box of a picture, in fractions of its sides.
glm::vec3 mean_colour(const Image& picture, glm::dvec2 low, glm::dvec2 high) {
  const glm::dvec2 size(picture.width, picture.height);
  glm::vec3 sum(0.0F);
  int count = 0;
  for (int y = static_cast<int>(low.y * size.y); y < high.y * size.y; ++y)
    for (int x = static_cast<int>(low.x * size.x); x < high.x * size.x; ++x, ++count)
      for (int c = 0; c < 3; ++c) sum[c] += picture.pixel(x, y)[c];
  return sum / static_cast<float>(count);
}

/// The sheet's picture of a frame of three, from 1.
Image frame_of(const Image& sheet, int frame) {
  constexpr int left = 24, top = 76, gap = 16, width = 453, height = 255;
  Image picture(width, height, 3);
  for (int y = 0; y < height; ++y)
    std::copy_n(sheet.pixel(left + (frame - 1) * (width + gap), top + y), 3 * width,
                picture.pixel(0, y));
  return picture;
}

TEST_F(Preview, ShowsWhatBlenderWillShow) {
  const fs::path root = tests_folder() / "..";
  const Image sheet = drawn(quoted((root / "examples/hillside.toml").string()));
  EXPECT_EQ(sheet.width, 1440);
  for (int frame = 1; frame <= 3; ++frame) {
    const Image sketch = frame_of(sheet, frame);
    const Image blender = read_image(root / "tests/golden" /
                                     ("hillside_blender_000" + std::to_string(frame) + ".png"));
    // The sky, the hills and the grass before them.
    for (const auto& [low, high] :
         {std::pair{0.0, 0.25}, std::pair{0.4, 0.55}, std::pair{0.7, 1.0}})
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(mean_colour(sketch, {0.0, low}, {1.0, high})[c],
                    mean_colour(blender, {0.0, low}, {1.0, high})[c], 0.09)
            << "frame " << frame << ", from " << low << " to " << high << ", channel " << c;
  }
}

TEST_F(Preview, IsTheSameBytesWithAnyNumberOfThreadsAndLeavesNothingElse) {
  write("a.toml",
        "name = \"a\"\n[terrain]\nsize = 8\n[grass]\nblades = 60\n[camera]\neye = [4, 1]\n"
        "target = [4, 6]\n[weather]\nprecipitation = 2\n[[clouds]]\n");
  ASSERT_EQ(wold("preview a.toml").out, "out/a/preview.png\n");
  ASSERT_EQ(wold("preview a.toml --out b.png --set render.threads=1").code, 0);
  EXPECT_EQ(read_file(folder_ / "b.png"), read_file(folder_ / "out/a/preview.png"));
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_))
    names.push_back(entry.path().filename().string());
  EXPECT_THAT(names, testing::UnorderedElementsAre("a.toml", "b.png", "out", ".out", ".err"));
  for (const auto& entry : fs::directory_iterator(folder_ / "out/a"))
    EXPECT_EQ(entry.path().filename(), "preview.png");
}

// Such a terrain has light for grass in its window of cells alone.
TEST_F(Preview, ShowsGrassInTheLightOnLargeTerrain) {
  write("a.toml",
        "[terrain]\nsize = 400\nsamples = 65\n[grass]\nblades = 60\n[camera]\neye = [200, 4]\n"
        "eye_height = 30\ntarget = [200, 130]\n");
  const Image sheet = drawn("a.toml");
  constexpr int left = 24, width = 218, below = 46, height = 196;  // of the first tuft
  float brightest = 0.0F;
  for (int y = sheet.height - below - height; y < sheet.height - below; ++y)
    for (int x = left; x < left + width; ++x) brightest = std::max(brightest, sheet.pixel(x, y)[1]);
  EXPECT_GT(brightest, 0.5F);  // the ground behind has 0.25
}

TEST_F(Preview, OfAWrongSceneOrToAWrongFileIsRefused) {
  write("a.toml", "seed = 'x'\n");
  write("b.toml", "");
  EXPECT_EQ(wold("preview a.toml").code, 2);
  const Result result = wold("preview b.toml --out b.gif");
  EXPECT_EQ(result.code, 2);
  expect_contains(result.err, "expected a file name that ends in .png");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace wold::test
