#include <gmock/gmock.h>

#include "core/files.h"
#include "core/image.h"
#include "small_film.h"

/// Clouds as files: each frame by itself, and pictures to look at and to use again.
namespace wold::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* clouds = R"(
[film]
frame_seconds = 30
[[clouds]]
kind = "cumulus"
gathered = 0.2
gusts = 2
cells = [2, 2]
[[clouds]]
kind = "stratocumulus"
base = 2500
motion = "paper"
cells = [2, 3]
[[cloud_events]]
kind = "gather"
start = 10
duration = 200
[[cloud_events]]
kind = "wind"
layer = 1
start = 40
duration = 120
heading = 200
[[cloud_events]]
kind = "light"
start = 60
duration = 100
)";

constexpr const char* towards_the_sky =
    " --set 'camera.target=[3, 4]' --set camera.target_height=0.5";

class CloudFilm : public SmallFilm {
 protected:
  void SetUp() override {
    SmallFilm::SetUp();
    write("cloudy.toml", read_file(folder_ / "small.toml") + clouds);
  }

  void generate(const std::string& folder, const std::string& frames) const {
    const Result result = wold("generate cloudy.toml --quiet --renderer both --out " + folder +
                               " --set 'ageing.frames=[0, 0.1, 0.2, 0.3, 0.4]'" + towards_the_sky +
                               " --frames " + frames);
    ASSERT_EQ(result.code, 0) << result.err;
  }

  /// Content hashes of the files of one frame, by their paths inside its folder.
  std::map<std::string, std::string> frame(const std::string& folder, const char* renderer,
                                           const char* number) const {
    return contents(folder + "/" + renderer + "/data/frame_" + number);
  }
};

TEST_F(CloudFilm, AFrameAloneIsTheFrameOfTheWholeFilm) {
  generate("whole", "1-5");
  generate("alone", "4");
  for (const char* renderer : {"blender", "povray"}) {
    const auto wanted = frame("whole", renderer, "0004");
    EXPECT_THAT(wanted, testing::Contains(testing::Key(testing::StartsWith("backdrop."))));
    EXPECT_THAT(different(frame("alone", renderer, "0004"), wanted), IsEmpty()) << renderer;
    const auto changed = different(frame("whole", renderer, "0005"), wanted);
    EXPECT_THAT(changed, testing::Contains(testing::StartsWith("backdrop.")));
  }
  EXPECT_THAT(different(contents("alone/clouds"), contents("whole/clouds")), IsEmpty());
  EXPECT_THAT(contents("whole/clouds"), SizeIs(2));
}

// A layer's picture in place of its recipe: a texture like any other.
TEST_F(CloudFilm, WritesTexturesThatCanBeUsedAgain) {
  generate("out", "1");
  const Image layer = read_image(folder_ / "out/clouds/layer_2.png");
  ASSERT_EQ(layer.channels, 4);
  EXPECT_NEAR(static_cast<double>(layer.height) / layer.width, 1.5, 0.01);
  std::size_t covered = 0;
  float brightest = 0.0F, darkest = 1.0F;
  for (std::size_t i = 0; i < layer.values.size(); i += 4) {
    if (layer.values[i + 3] < 0.02F) continue;
    ++covered;
    brightest = std::max(brightest, layer.values[i]);
    darkest = std::min(darkest, layer.values[i]);
  }
  const double pixels = static_cast<double>(layer.width) * layer.height;
  EXPECT_NEAR(static_cast<double>(covered) / pixels, 0.75, 0.08);  // models/cloud/stratocumulus
  EXPECT_GT(brightest, 0.9F);
  EXPECT_LT(darkest, 0.75F);
  const Result again = wold(
      "generate cloudy.toml --quiet --renderer blender --out again --frames 1 "
      "--set 'clouds[1].textures=[\"out/clouds/layer_2.png\"]'" +
      std::string(towards_the_sky));
  ASSERT_EQ(again.code, 0) << again.err;
  const auto changed =
      different(frame("again", "blender", "0001"), frame("out", "blender", "0001"));
  EXPECT_THAT(changed, testing::Contains(testing::StartsWith("backdrop.")));
}

}  // namespace
}  // namespace wold::test
