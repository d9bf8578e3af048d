#include <gmock/gmock.h>

#include "blender/renderer.h"
#include "core/error.h"
#include "fake_renderer.h"
#include "povray/renderer.h"
#include "render/command.h"

namespace wold::test {
namespace {

using ::testing::HasSubstr;

constexpr const char* ball = R"(#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0, -3> look_at 0 }
sphere { 0, FRAME / 4 pigment { rgb 1 } finish { emission 1 } }
)";

/// Skips the test aloud where the real program is missing.
class RealPovray : public FakeRenderer {
 protected:
  void SetUp() override {
    try {
      povray_ = render::find_renderer(povray::renderer());
    } catch (const RendererError& error) {
      GTEST_SKIP() << error.what();
    }
  }
  render::Job povray_job() const {
    render::Job result = job();
    result.program.kind = &povray::renderer();
    result.program.found = povray_;
    return result;
  }

 private:
  render::FoundProgram povray_;
};

TEST_F(RealPovray, RendersBelowAFolderWithSpaces) {
  write_file(folder_ / "scene/scene.pov", ball);
  SilentProgress progress;
  render::run(povray_job(), progress, never);
  const Image image = read_image(povray_job().picture);
  // frame 3: the ball covers the middle of the picture and leaves its corner free
  EXPECT_FLOAT_EQ(image.pixel(16, 9)[0], 1.0F);
  EXPECT_FLOAT_EQ(image.pixel(0, 0)[0], 0.0F);
}

TEST_F(RealPovray, ASceneErrorReachesTheUser) {
  write_file(folder_ / "scene/scene.pov", "#version 3.7;\nsphre { 0, 1 }\n");
  EXPECT_THAT(failure_of<RendererError>(povray_job()), HasSubstr("undeclared"));
}

TEST(ProgressLines, AreUnderstood) {
  using render::progress_fraction;
  EXPECT_DOUBLE_EQ(*progress_fraction(povray::renderer(), "Rendered 1024 of 4096 pixels (25%)"),
                   0.25);
  EXPECT_DOUBLE_EQ(*progress_fraction(blender::renderer(), "wold: progress 0.125"), 0.125);
  EXPECT_DOUBLE_EQ(*progress_fraction(blender::renderer(), "wold: progress 7"), 1.0);
  EXPECT_FALSE(progress_fraction(blender::renderer(), "wold: progress nan"));
  EXPECT_FALSE(progress_fraction(povray::renderer(), "Rendered 0 of 0 pixels"));
  EXPECT_FALSE(progress_fraction(povray::renderer(), "Rendered: nothing"));
}

}  // namespace
}  // namespace wold::test
