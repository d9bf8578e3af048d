// A renderer that leaves out grass or clouds is caught by its picture, whatever it says. Skipped
// where it is missing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/files.h"
#include "render/renderer_program.h"
#include "render/run.h"
#include "support/cloudy_view.h"
#include "support/export_all.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"

namespace wold {
namespace {

namespace fs = std::filesystem;
using landscape::Landscape;

class WithoutThings : public testing::TestWithParam<const exporter::Exporter*> {
 protected:
  void SetUp() override {
    try {
      const render::Renderer& renderer = *GetParam()->renderer;
      program_ = render::recognise(renderer, render::find_renderer(renderer), never);
    } catch (const RendererError& error) {
      GTEST_SKIP() << error.what();
    }
  }

  /// Renders `drawn` where the picture of `wanted` is expected.
  void render(const Landscape& drawn, const Landscape& wanted) const {
    const fs::path scene_folder = folder_.path() / "scene";
    const fs::path expected = "data/frame_0001/expected.json";
    export_to(wanted, folder_.path() / "wanted");
    export_to(drawn, scene_folder);
    SilentProgress progress;
    render::Job job;
    job.program = program_;
    job.scene_folder = scene_folder;
    job.size_px = {wanted.width_px, wanted.height_px};
    job.samples = 4;
    job.timeout = std::chrono::seconds(300);
    job.picture = folder_.path() / "picture.png";
    job.log = folder_.path() / "log";
    job.expected = folder_.path() / "wanted" / expected;
    render::run(job, progress, never);
  }

  /// What the renderer is blamed for; empty when nothing is.
  std::string blame(const Landscape& drawn, const Landscape& wanted) const {
    try {
      render(drawn, wanted);
    } catch (const RendererError& error) {
      EXPECT_FALSE(fs::exists(folder_.path() / "picture.png"));
      return error.what();
    }
    return {};
  }

  Landscape meadow(int cells_per_side = 6) const {
    return test::synthetic_landscape({.cells_per_side = cells_per_side, .height_voxels = 10},
                                     folder_.path() / "texels");
  }

 private:
  static void export_to(const Landscape& landscape, const fs::path& folder) {
    test::export_all(*GetParam(), landscape, folder);
  }

  static bool never() { return false; }

  render::RendererProgram program_;
  const test::TemporaryFolder folder_{"without_things"};
};

TEST_P(WithoutThings, GrassThatIsNotDrawnIsMissed) {
  const Landscape wanted = meadow();
  EXPECT_EQ(blame(wanted, wanted), "");
  Landscape bare = wanted;
  bare.cells.clear();
  EXPECT_THAT(blame(bare, wanted), testing::HasSubstr("of the grass that should be there"));
}

TEST_P(WithoutThings, HalfOfTheGrassIsMissed) {
  const Landscape wanted = meadow(10);
  EXPECT_EQ(blame(wanted, wanted), "");
  Landscape half = wanted;
  std::erase_if(half.cells, [&](const landscape::Cell& cell) { return cell.volume == 0; });
  EXPECT_THAT(blame(half, wanted), testing::HasSubstr("of the grass that should be there"));
}

TEST_P(WithoutThings, BladesThatAreNotDrawnAreMissed) {
  Landscape wanted = meadow();
  for (const landscape::Cell& cell : wanted.cells)
    wanted.blade_cells.push_back({cell.world_from_cell, 0});
  wanted.cells.clear();
  EXPECT_EQ(blame(wanted, wanted), "");
  Landscape bare = wanted;
  bare.blade_cells.clear();
  EXPECT_THAT(blame(bare, wanted), testing::HasSubstr("of the blades that should be there"));
}

TEST_P(WithoutThings, CloudsThatAreNotDrawnAreMissed) {
  Landscape wanted = meadow();
  test::make_cloudy_view(wanted);
  EXPECT_EQ(blame(wanted, wanted), "");
  Landscape clear = wanted;
  clear.clouds.clear();
  EXPECT_THAT(blame(clear, wanted), testing::HasSubstr("of the clouds that should be there"));
}

INSTANTIATE_TEST_SUITE_P(All, WithoutThings, testing::ValuesIn(test::exporters_with_a_renderer()),
                         [](const auto& tested) { return std::string(tested.param->name); });

}  // namespace
}  // namespace wold
