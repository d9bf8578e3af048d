#include <gtest/gtest.h>

#include "blender/renderer.h"
#include "core/error.h"
#include "fake_renderer.h"

namespace wold::test {
namespace {

// Answers the command line of a launcher without rendering anything: frame 3 of the test's
// job is a picture of 32 x 18 pixels, red rising to the right.
constexpr const char* script = R"(import sys
import bpy
arguments = sys.argv[sys.argv.index("--") + 1:]
assert arguments[0].endswith("/scene") and arguments[0] not in sys.path, arguments
options = dict(zip(arguments[2::2], arguments[3::2]))
width, height = map(int, options["--size"].split("x"))
print("wold: progress 0.5", flush=True)
image = bpy.data.images.new("ramp", width, height)
image.pixels = [value for i in range(width * height) for value in (i % width / width, 0, 0, 1)]
image.file_format = "PNG"
image.filepath_raw = options["--out"]
if arguments[1] == "3":
    image.save()
)";

TEST_F(FakeRenderer, RealBlenderRunsTheLauncherForAFolderWithSpaces) {
  render::Job real = job();
  try {
    real.program.found = render::find_renderer(blender::renderer());
  } catch (const RendererError& error) {
    GTEST_SKIP() << error.what();
  }
  write_file(real.program.launcher, script);
  SilentProgress progress;
  render::run(real, progress, never);
  EXPECT_NEAR(read_image(job().picture).pixel(16, 5)[0], 0.5F, 0.01F);
}

}  // namespace
}  // namespace wold::test
