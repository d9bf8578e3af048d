#include "shutter/motion_field.h"

#include <gmock/gmock.h>

#include <limits>
#include <string>

#include "core/error.h"
#include "core/layered_image.h"
#include "support/temporary_folder.h"

namespace wold::shutter {
namespace {

using testing::HasSubstr;

class MotionFieldFile : public testing::Test {
 protected:
  void write(const std::vector<ImageChannel>& channels) const {
    write_layered_image(file(), {2, 1, channels, {}});
  }
  std::filesystem::path file() const { return folder_.path() / "0001.exr"; }
  std::string fault() const {
    try {
      read_motion_field(file());
      return "";
    } catch (const FileError& error) {
      return error.what();
    }
  }

 private:
  test::TemporaryFolder folder_{"motion_field"};
};

TEST_F(MotionFieldFile, HasEachPixelsMotionAndDepth) {
  write({{"motion.X", PixelFormat::float32, {1.5F, -2.0F}},
         {"motion.Y", PixelFormat::float32, {0.25F, 3.0F}},
         {"depth.Z", PixelFormat::float32, {4.0F, 1e10F}}});
  const MotionField field = read_motion_field(file());
  EXPECT_EQ(field.width, 2);
  EXPECT_EQ(field.height, 1);
  EXPECT_EQ(field.motion_px[field.index(1, 0)], glm::vec2(-2.0F, 3.0F));
  EXPECT_EQ(field.depth_m, (std::vector<float>{4.0F, 1e10F}));
}

TEST_F(MotionFieldFile, SaysWhatIsMissing) {
  EXPECT_THAT(fault(), HasSubstr("0001.exr"));
  write({{"motion.X", PixelFormat::float32, {1.0F, 1.0F}},
         {"motion.Y", PixelFormat::float32, {1.0F, 1.0F}}});
  EXPECT_THAT(fault(), HasSubstr("has no \"depth.Z\"; `wold passes` with --passes depth,motion"));
}

TEST_F(MotionFieldFile, RefusesWhatIsNotFinite) {
  write({{"motion.X", PixelFormat::float32, {1.0F, std::numeric_limits<float>::quiet_NaN()}},
         {"motion.Y", PixelFormat::float32, {1.0F, 1.0F}},
         {"depth.Z", PixelFormat::float32, {1.0F, 1.0F}}});
  EXPECT_THAT(fault(), HasSubstr("\"motion.X\" holds nan, expected finite numbers"));
}

}  // namespace
}  // namespace wold::shutter
