#include <gmock/gmock.h>

#include <array>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/image.h"
#include "program.h"
#include "support/places.h"

namespace wold::test {
namespace {

using Colour = std::array<float, 3>;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr Colour red = {0.75F, 0.125F, 0.125F};
constexpr Colour blue = {0.125F, 0.125F, 0.75F};
constexpr Colour green = {0.125F, 0.5F, 0.125F};
constexpr Colour straw = {0.75F, 0.625F, 0.25F};

/// Reports of flat pictures, looked at by a browser.
class Report : public Program {
 protected:
  void draw(const std::string& renderer, int number, const Colour& colour, int width = 320) const {
    Image image(width, width * 9 / 16, 3);
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = colour[i % 3];
    const fs::path picture =
        folder_ / "d/frames" / renderer / ("000" + std::to_string(number) + ".png");
    make_folder(picture.parent_path());
    write_image(picture, image, PixelFormat::uint8);
  }

  std::string page() const { return read_file(folder_ / "d/report.html"); }

  bool has_browser() const { return is_installed("chromedriver") && is_installed("chromium"); }

  /// What a reader sees and does, by tests/cli/report_browser.py.
  nlohmann::json used() const {
    const Result result = shell("python3 '" + (tests_folder() / "cli/report_browser.py").string() +
                                "' d/report.html");
    EXPECT_EQ(result.code, 0) << result.err;
    return nlohmann::json::parse(result.out);
  }

  /// A pixel of a screenshot, at fractions of its width and height.
  void expect_colour(const std::string& screenshot, double x, double y, const Colour& want) const {
    const Image image = read_image(folder_ / screenshot);
    const float* pixel =
        image.pixel(static_cast<int>(x * image.width), static_cast<int>(y * image.height));
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(pixel[c], want[c], 6.0 / 255.0)
          << screenshot << " at " << x << ", " << y << ", channel " << c;
  }
};

void expect_sound(const nlohmann::json& seen) {
  EXPECT_EQ(seen.at("console"), nlohmann::json::array());
  EXPECT_EQ(seen.at("outside"), nlohmann::json::array());
  EXPECT_EQ(seen.at("widths"), nlohmann::json({360, 360, 360}));  // nothing to scroll sideways
  EXPECT_EQ(seen.at("dark"), "rgb(19, 22, 20)");
}

TEST_F(Report, AgesAndWipesInABrowser) {
  if (!has_browser()) GTEST_SKIP() << "no chromium and chromium-driver on this machine";
  draw("blender", 1, green);
  draw("blender", 2, red);
  draw("blender", 3, red);
  draw("povray", 1, blue);
  draw("povray", 2, blue);
  draw("povray", 3, straw);
  write("d/scene.toml", "name = \"heath\"\n[ageing]\nframes = [0, 0.25, 0.875]\n");
  write("d/manifest.json", "{}");
  const Result made = wold("report d --quiet");
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.out, "d/report.html\n");
  EXPECT_EQ(made.err, "");

  const nlohmann::json seen = used();
  expect_sound(seen);
  const std::string first = "Frame 1 of 3 · weathering degree 0.00";
  const std::string last = "Frame 3 of 3 · weathering degree 0.875";
  EXPECT_EQ(seen.at("title"), "heath · Wold");
  EXPECT_EQ(seen.at("first"), first);
  EXPECT_EQ(seen.at("right"), "Frame 2 of 3 · weathering degree 0.25");
  EXPECT_EQ(seen.at("end"), last);
  EXPECT_EQ(seen.at("home"), first);
  EXPECT_EQ(seen.at("dragged"), last);
  EXPECT_EQ(seen.at("dragged home"), first);
  EXPECT_THAT(seen.at("playing"), Not(first));
  EXPECT_EQ(seen.at("paused"), "Play");
  EXPECT_EQ(seen.at("wiped"), "20");
  EXPECT_EQ(seen.at("wiped by keys"), "24");
  EXPECT_EQ(seen.at("frame after wiping"), first);  // its keys are not time's
  EXPECT_EQ(seen.at("picture dragged"), last);

  expect_colour("first.png", 0.3, 0.8, green);
  expect_colour("first.png", 0.7, 0.8, blue);
  expect_colour("last.png", 0.3, 0.8, red);
  expect_colour("last.png", 0.7, 0.8, straw);
  expect_colour("wiped.png", 0.1, 0.8, green);
  expect_colour("wiped.png", 0.3, 0.8, blue);
  expect_colour("side.png", 0.3, 0.8, green);
  expect_colour("side.png", 0.7, 0.8, blue);
  expect_colour("only-0.png", 0.7, 0.8, green);
  expect_colour("only-1.png", 0.3, 0.8, blue);
}

TEST_F(Report, OfOnePictureAloneIsWholeAndSoIsOneOfNone) {
  draw("povray", 1, blue);
  ASSERT_EQ(wold("report d").code, 0);
  if (!has_browser()) GTEST_SKIP() << "no chromium and chromium-driver on this machine";
  const nlohmann::json seen = used();
  expect_sound(seen);
  EXPECT_EQ(seen.at("end"), "Frame 1 of 1");
  EXPECT_THAT(seen.at("text"), HasSubstr("The scene is not known"));
  expect_colour("first.png", 0.7, 0.8, blue);

  fs::remove_all(folder_ / "d/frames");
  write("d/scene.toml", "");
  ASSERT_EQ(wold("report d").code, 0);
  const nlohmann::json empty = used();
  expect_sound(empty);
  EXPECT_THAT(empty.at("text"), HasSubstr("No pictures yet."));
}

TEST_F(Report, SaysWhatIsMissingDamagedOrWarnedOf) {
  for (const int frame : {1, 2, 4}) draw("povray", frame, blue);
  draw("blender", 1, red);
  write("d/frames/blender/0002.png", "no picture");
  write("d/scene.toml", "[ageing]\nframes = [0, 0.2, 0.4, 0.6]\n");
  make_folder(folder_ / "d/logs");
  write("d/logs/povray_0001.log", "Warning Stream to console.......On\n");
  write("d/logs/povray_0002.log", "File 'a<b>.pov' line 3: Parse Warning: odd & old\n");
  ASSERT_EQ(wold("report d").code, 0);
  const std::string text = page();
  for (const char* warning :
       {"Blender has no pictures of the frames 3-4.", "POV-Ray has no pictures of the frames 3.",
        "d/frames/blender/0002.png is damaged.", "There is no manifest.json",
        "Log: File 'a&lt;b&gt;.pov' line 3: Parse Warning: odd &amp; old"})
    EXPECT_THAT(text, HasSubstr(warning));
  EXPECT_THAT(text, Not(HasSubstr("Warning Stream")));
}

TEST_F(Report, ShowsKeysAndTimesAndEscapesWhatIsNotItsOwn) {
  draw("povray", 1, blue);
  const std::string evil = "<script>alert(1)<!-- DATA -->";
  write("d/" + evil, "");
  write("d/scene.toml", "[grass]\nblades = 123\n[growth]\nmask = '" + evil + "'\n");
  make_folder(folder_ / "d/tasks");
  write(
      "d/tasks/povray_0001.json",
      R"({"version":1,"stage":"povray","index":1,"source":"","scene":"","seconds":83.5,"memory_bytes":0,)"
      R"("outputs":{}})");
  ASSERT_EQ(wold("report d --out other.html").code, 0);
  const std::string text = read_file(folder_ / "other.html");
  EXPECT_FALSE(fs::exists(folder_ / "d/report.html"));
  EXPECT_THAT(text, HasSubstr("<tr class=\"own\"><td>blades</td><td>123</td>"));
  EXPECT_THAT(text, HasSubstr("<tr class=\"usual\"><td>variants</td><td>4</td>"));
  EXPECT_THAT(text, HasSubstr("1 min 24 s"));
  EXPECT_THAT(text, Not(HasSubstr("<script>alert")));
  ASSERT_EQ(wold("report d --out again.html").code, 0);
  EXPECT_EQ(read_file(folder_ / "again.html"), text);
}

TEST_F(Report, OfManyFramesStaysSmall) {
  Image noise(480, 270, 3);
  std::uint32_t state = 1;
  for (float& value : noise.values) {
    state = state * 1664525U + 1013904223U;  // what JPEG cannot compress
    value = static_cast<float>(state >> 8U) / static_cast<float>(1U << 24U);
  }
  make_folder(folder_ / "d/frames/povray");
  write_image(folder_ / "noise.png", noise, PixelFormat::uint8);
  for (int frame = 1; frame <= 260; ++frame) {
    std::string name = "000" + std::to_string(frame) + ".png";
    name.erase(0, name.size() - 8);
    fs::create_hard_link(folder_ / "noise.png", folder_ / "d/frames/povray" / name);
  }
  ASSERT_EQ(wold("report d").code, 0);
  EXPECT_LT(fs::file_size(folder_ / "d/report.html"), 30'000'000U);
  EXPECT_THAT(page(), HasSubstr("it shows 130 of 260 frames."));
}

TEST_F(Report, OfWhatIsNoOutputFolderIsRefused) {
  make_folder(folder_ / "empty");
  EXPECT_EQ(wold("report nowhere").code, 4);
  const Result empty = wold("report empty");
  EXPECT_EQ(empty.code, 4);
  EXPECT_THAT(empty.err, StartsWith("error: found neither scene.toml nor frames in empty,"));
  EXPECT_TRUE(fs::is_empty(folder_ / "empty"));
}

}  // namespace
}  // namespace wold::test
