// A stranger's data folder is data: no program in it is run, wherever Blender is started.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "blender/export.h"
#include "blender/renderer.h"
#include "core/files.h"
#include "render/command.h"
#include "render/short_run.h"
#include "support/blender.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"

namespace wold::blender {
namespace {

namespace fs = std::filesystem;

/// Names that Python, Blender or an earlier version of Wold look for.
constexpr const char* baits[] = {"json.py",
                                 "os.py",
                                 "numpy.py",
                                 "bpy.py",
                                 "mathutils.py",
                                 "sitecustomize.py",
                                 "usercustomize.py",
                                 "scene.py",
                                 "wold_addon.py",
                                 "wold_render.py",
                                 "wold_blender/__init__.py",
                                 "startup/wold.py",
                                 "scripts/startup/wold.py",
                                 "scripts/addons/wold/__init__.py"};

class BlenderStranger : public testing::Test {
 protected:
  void SetUp() override {
    if (!test::has_blender()) GTEST_SKIP() << "no Blender on this machine: folders not tried";
    const fs::path& root = folder_.path();
    export_frame(test::synthetic_landscape({.width_px = 32, .height_px = 18}, root / "texels"),
                 data());
    make_folder(marks());
    for (const fs::path& place : {data(), data() / "data", frame()}) lay_baits(place);
  }

  fs::path data() const { return folder_.path() / "blender"; }
  fs::path frame() const { return data() / "data/frame_0001"; }
  fs::path marks() const { return folder_.path() / "marks"; }
  fs::path picture() const { return folder_.path() / "picture.png"; }

  /// Each writes a mark when it is run.
  void lay_baits(const fs::path& place) const {
    for (const std::string bait : baits) {
      std::string mark = fmt::format("{}_{}", place.filename().string(), bait);
      std::replace(mark.begin(), mark.end(), '/', '_');
      make_folder((place / bait).parent_path());
      write_file(place / bait, fmt::format("open('{}', 'w')\n", (marks() / mark).string()));
    }
  }

  /// The command that `wold render` runs.
  render::Command command() const {
    render::Job job;
    job.program =
        render::recognise(blender::renderer(), render::find_renderer(blender::renderer()), never);
    job.scene_folder = data();
    job.size_px = {32, 18};
    return render::render_command(job, picture());
  }

  void expect_no_bait_is_run_from(const fs::path& started_in) const {
    const render::Answer answer = render::ask(command().arguments, started_in, never);
    EXPECT_TRUE(render::has_succeeded(answer)) << render::last_lines(answer);
    EXPECT_TRUE(fs::exists(picture()));
    for (const auto& mark : fs::directory_iterator(marks()))
      ADD_FAILURE() << "was run: " << mark.path().filename();
  }

 private:
  static bool never() { return false; }

  const test::TemporaryFolder folder_{"stranger"};
};

TEST_F(BlenderStranger, FoldersAreNotRun) { expect_no_bait_is_run_from(command().folder); }

TEST_F(BlenderStranger, FoldersAreNotRunWhenBlenderIsStartedInThem) {
  expect_no_bait_is_run_from(data());
}

TEST_F(BlenderStranger, FramesAreNotRunWhenBlenderIsStartedInThem) {
  expect_no_bait_is_run_from(frame());
}

}  // namespace
}  // namespace wold::blender
