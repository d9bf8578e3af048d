#include "render/missing_things.h"

#include <gmock/gmock.h>

#include "core/colour.h"
#include "core/error.h"
#include "fake_renderer.h"
#include "render/shown_fraction.h"

namespace wold::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Green things on brown ground, in the lower of two rows of four tiles; above them a white sky.
ExpectedPicture expected_things(const char* name, double min_fraction = 0.85) {
  ExpectedThings things{name, min_fraction, {}};
  for (int tile = 4; tile < 8; ++tile)
    things.tiles.push_back({tile, glm::vec3(0.1F, 0.3F, 0.05F), glm::vec3(0.12F, 0.08F, 0.05F)});
  return {{4, 2}, {things}};
}

/// What is seen if `fraction` of the pixels of each tile show the things.
Image picture_with(const ExpectedPicture& expected, double fraction) {
  Image picture(32, 18, 3);
  std::fill(picture.values.begin(), picture.values.end(), 1.0F);
  const ExpectedTile& tile = expected.things.front().tiles.front();
  for (int y = 9; y < 18; ++y)
    for (int x = 0; x < 32; ++x) {
      const glm::vec3& colour = x % 8 < 8 * fraction ? tile.with : tile.without;
      for (int c = 0; c < 3; ++c)
        picture.pixel(x, y)[c] = static_cast<float>(srgb_encoded(double{colour[c]}));
    }
  return picture;
}

/// A job whose Blender draws that picture.
class MissingThings : public FakeRenderer {
 protected:
  render::Job job_of(const ExpectedPicture& expected, double fraction) {
    write_image(folder_ / "drawn.png", picture_with(expected, fraction), PixelFormat::uint8);
    play("cp \"$folder/drawn.png\" \"$out\"");
    render::Job job = this->job();
    job.expected = folder_ / "expected.json";
    write_expected_picture(job.expected, expected);
    return job;
  }

  void expect_done(const render::Job& job) const {
    SilentProgress progress;
    render::run(job, progress, never);
    EXPECT_TRUE(fs::exists(job.picture));
  }
};

TEST_F(MissingThings, PictureThatShowsThemIsDone) {
  expect_done(job_of(expected_things("grass"), 1.0));
}

TEST_F(MissingThings, PictureWithoutGrassFailsAndSaysWhatToDo) {
  EXPECT_THAT(failure_of<RendererError>(job_of(expected_things("grass"), 0.0)),
              AllOf(HasSubstr("Blender failed on frame 3"),
                    HasSubstr("shows 0 % of the grass that should be there"),
                    HasSubstr("`wold doctor`"), HasSubstr("`--grass blades`")));
}

TEST_F(MissingThings, CloudsAreNamedAndCannotBeBlades) {
  EXPECT_THAT(
      failure_of<RendererError>(job_of(expected_things("clouds"), 0.0)),
      AllOf(HasSubstr("0 % of the clouds"), HasSubstr("`wold doctor`"), Not(HasSubstr("--grass"))));
}

TEST_F(MissingThings, BladesHaveNothingToDoWithVolumes) {
  EXPECT_THAT(failure_of<RendererError>(job_of(expected_things("blades"), 0.0)),
              AllOf(HasSubstr("0 % of the blades"), Not(HasSubstr("volumes"))));
}

// Half of the pixels show it. The limit comes with what is expected.
TEST_F(MissingThings, HalfAMeadowIsJudgedByItsLimit) {
  EXPECT_THAT(failure_of<RendererError>(job_of(expected_things("grass", 0.85), 0.5)),
              HasSubstr("of the grass that should be there"));
  expect_done(job_of(expected_things("grass", 0.3), 0.5));
}

// Grass nearly as the ground is: whether it is there cannot be seen.
TEST_F(MissingThings, WhatWouldHardlyBeSeenIsNotLookedFor) {
  ExpectedPicture expected = expected_things("grass");
  const Image without = picture_with(expected, 0.0);
  for (ExpectedTile& tile : expected.things.front().tiles)
    tile.with = tile.without + glm::vec3(0.002F, 0.004F, 0.0F);
  const render::Job job = job_of(expected, 0.0);
  write_image(folder_ / "drawn.png", without, PixelFormat::uint8);
  expect_done(job);
}

TEST_F(MissingThings, DamagedExpectationIsAFileErrorBeforeAnythingIsRendered) {
  const render::Job job = job_of(expected_things("grass"), 1.0);
  play("touch \"$folder/called\"");
  write_file(job.expected, "{");
  EXPECT_THAT(failure_of<FileError>(job), HasSubstr("expected.json is damaged"));
  fs::remove(job.expected);
  EXPECT_THAT(failure_of<FileError>(job), HasSubstr("expected.json"));
  EXPECT_FALSE(fs::exists(folder_ / "called"));
}

// By hand: of the change from `without` to `with`, the tiles have 0.5 in the mean of sRGB.
TEST(ShownFraction, IsTheShareOfTheChange) {
  const ExpectedPicture expected{{2, 1}, {{"grass", 0.5, {{0, glm::vec3(1.0F), glm::vec3(0.0F)}}}}};
  Image picture(4, 2, 3);
  std::fill(picture.values.begin(), picture.values.end(), 0.5F);
  const render::ShownFraction shown =
      render::shown_fraction(picture, expected, expected.things.front());
  EXPECT_NEAR(shown.fraction, 0.5, 1e-6);
  EXPECT_NEAR(shown.contrast, std::sqrt(0.5), 1e-6);
}

}  // namespace
}  // namespace wold::test
