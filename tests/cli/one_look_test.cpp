#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/files.h"
#include "core/image.h"
#include "program.h"
#include "support/blurred_difference.h"
#include "support/places.h"

/// The promise of one look: both renderers show the same landscape.
namespace wold::test {
namespace {

struct ExampleFilm {
  const char* example;
  std::vector<int> frames;
  bool clear;  ///< the skyline stands out from the sky
};

/// For the names of tests, which would have the object's bytes else.
void PrintTo(const ExampleFilm& film, std::ostream* out) { *out << film.example; }

/// First row from the top, column by column, that is no longer sky: grass and rock are darker than
/// the sky at its brightest, which is at the horizon. Where it lies between two rows is read off
/// the brightness.
std::vector<double> skyline(const Image& picture) {
  const auto blue = [&](int x, int y) { return double{picture.pixel(x, y)[2]}; };
  std::vector<double> rows;
  for (int x = 0; x < picture.width; ++x) {
    int y = 2;
    double brightest = std::max({blue(x, 0), blue(x, 1), blue(x, 2)});
    while (y + 2 < picture.height && blue(x, y + 1) > 0.8 * brightest)
      brightest = std::max(brightest, blue(x, ++y));
    const double sky = blue(x, y - 2);
    const double land = blue(x, std::min(y + 2, picture.height - 1));
    rows.push_back(y + std::clamp((blue(x, y) - land) / std::max(sky - land, 1e-3), 0.0, 1.0));
  }
  return rows;
}

/// Distance between two skylines in pixels, at the worst but a hundredth of the columns: single
/// blades stand out of them.
double skyline_difference(const Image& a, const Image& b) {
  const std::vector<double> ours = skyline(a);
  const std::vector<double> theirs = skyline(b);
  std::vector<double> apart;
  for (std::size_t x = 0; x < ours.size(); ++x) apart.push_back(std::abs(ours[x] - theirs[x]));
  std::sort(apart.begin(), apart.end());
  return apart[apart.size() * 99 / 100];
}

Image difference(const Image& a, const Image& b) {
  Image picture(a.width, a.height, 3);
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.values[i] = 0.5F + 2.0F * (a.values[i] - b.values[i]);
  return picture;
}

class OneLook : public Program, public testing::WithParamInterface<ExampleFilm> {
 protected:
  void SetUp() override {
    Program::SetUp();
    for (const char* renderer : {"blender", "povray"})
      if (!can_render(renderer))
        GTEST_SKIP() << "no complete " << renderer
                     << " on this machine: the two looks are not compared";
  }

  fs::path picture(const char* renderer, int frame) const {
    return folder_ / fmt::format("out/frames/{}/{:04}.png", renderer, frame);
  }

  /// Keeps both pictures, their difference, doubled about grey, and the numbers in the build
  /// folder.
  void keep(int frame, const Image& apart, double blur, double skyline_px) const {
    const fs::path evidence =
        build_folder() / "one_look" / fmt::format("{}_{:04}", GetParam().example, frame);
    fs::create_directories(evidence);
    for (const char* renderer : {"blender", "povray"})
      fs::copy_file(picture(renderer, frame), evidence / (std::string(renderer) + ".png"),
                    fs::copy_options::overwrite_existing);
    write_image(evidence / "difference.png", apart, PixelFormat::uint8);
    const nlohmann::ordered_json numbers = {{"blurred_difference_of_255", 255.0 * blur},
                                            {"skyline_px", skyline_px}};
    write_file(evidence / "numbers.json", numbers.dump(2) + "\n");
    fmt::print("{} frame {}: {:.2f} of 255, skyline {:.2f} px\n", GetParam().example, frame,
               255.0 * blur, skyline_px);
  }
};

TEST_P(OneLook, BothRenderersShowTheSame) {
  const Result made = wold(
      fmt::format("render '{}/../examples/{}.toml' --quiet --out out --renderer both --frames {} "
                  "--size 240x136 --samples 9 --set 'grass.levels=[126, 62, 30]'",
                  tests_folder().string(), GetParam().example, fmt::join(GetParam().frames, ",")));
  ASSERT_EQ(made.code, 0) << made.err;
  for (const int frame : GetParam().frames) {
    const Image blender = read_image(picture("blender", frame));
    const Image povray = read_image(picture("povray", frame));
    const double blur = blurred_difference(blender, povray);
    const double skyline_px = GetParam().clear ? skyline_difference(blender, povray) : 0.0;
    EXPECT_LE(blur, 5.0 / 255.0) << "frame " << frame;
    EXPECT_LE(skyline_px, 1.0) << "frame " << frame;
    keep(frame, difference(blender, povray), blur, skyline_px);
  }
}

// Weathering degrees 0, 0.30 and 0.917; a mountain in summer, after the first snow and in deep
// snow; clouds that have gathered; half-way into the snow; snow in a storm.
INSTANTIATE_TEST_SUITE_P(Landscape, OneLook,
                         testing::Values(ExampleFilm{"hillside", {1, 2, 3}, true},
                                         ExampleFilm{"mountain", {1, 3, 5}, false},
                                         ExampleFilm{"clouds", {45}, false},
                                         ExampleFilm{"first_snow", {24}, false},
                                         ExampleFilm{"ground_blizzard", {1}, false}),
                         [](const auto& test) { return std::string(test.param.example); });

}  // namespace
}  // namespace wold::test
