#include <gtest/gtest.h>

#include "film/exporters.h"
#include "support/file_only_exporter.h"
#include "support/temporary_folder.h"
#include "work/batches.h"
#include "work/disk_budget.h"
#include "work/do_tasks.h"
#include "work/folder_lock.h"
#include "work/plan.h"
#include "work/tasks.h"

namespace wold::work {
namespace {

Job job_of(std::vector<const exporter::Exporter*> exporters) {
  Job job;
  job.scene.terrain.size_m = 6.0;
  job.scene.terrain.samples = 33;
  job.scene.terrain.hill_height_m = 0.5;
  job.scene.grass.lods = {16};
  job.scene.grass.variants = 2;
  job.scene.camera.eye_m = {3.0, 0.5};
  job.scene.camera.target_m = {3.0, 4.0};
  job.scene.render.size_px = {48, 27};
  job.scene.ageing.frames = {0.0, 0.5};
  job.frames = {1, 2};
  job.exporters = std::move(exporters);
  return job;
}

std::string names_of(const std::vector<StageTasks>& stages) {
  std::string names;
  for (const StageTasks& stage : stages) names += std::string(name_of(stage.stage)) + " ";
  return names;
}

TEST(Stages, EndWithPicturesOfEachExporterThatHasARenderer) {
  const exporter::Exporters all = film::exporters();
  std::vector<const exporter::Exporter*> exporters(all.begin(), all.end());
  exporters.push_back(&test::file_only_exporter());
  std::string expected = "texels scenes ";
  for (const exporter::Exporter* one : all)
    if (one->renderer) expected += std::string(one->name) + " ";
  const std::vector<StageTasks> stages = stages_of(job_of(exporters));
  EXPECT_EQ(names_of(stages), expected);
  EXPECT_EQ(stages.back().stage.exporter->name, name_of(stages.back().stage));
}

TEST(Stages, HavePassesWhereTheyAreWantedAndSceneFilesWhereThereAreExporters) {
  Job job = job_of({&test::file_only_exporter()});
  job.passes = {passes::Pass::depth};
  const std::vector<StageTasks> stages = stages_of(job);
  EXPECT_EQ(names_of(stages), "texels passes scenes ");
  EXPECT_EQ(stages[1].after_all, Stage::texels);
  EXPECT_EQ(stages[1].indices, job.frames);
  job.exporters.clear();
  EXPECT_EQ(names_of(stages_of(job)), "texels passes ");
}

TEST(Stages, OfAnExporterWithoutARendererAreDoneWithItsFiles) {
  const test::TemporaryFolder folder("file_only");
  Job job = job_of({&test::file_only_exporter()});
  job.out = folder.path();
  const std::vector<StageTasks> stages = stages_of(job);
  EXPECT_EQ(names_of(stages), "texels scenes ");
  SilentProgress progress;
  {
    Renderers renderers(job, progress);
    require_renderers(job, stages, renderers);
    const FolderLock lock(job.out, Access::alone, progress);
    Work work(job, &renderers);
    EXPECT_GT(missing_bytes(job, stages, work), 0.0);
    do_tasks(job, work, stages, progress);
    EXPECT_EQ(missing_bytes(job, stages, work), 0.0);
    work.finish();
  }
  EXPECT_TRUE(std::filesystem::exists(job.out / "lines/0002.txt"));
  EXPECT_TRUE(std::filesystem::exists(job.out / "film.txt"));
  EXPECT_FALSE(std::filesystem::exists(job.out / "frames"));
  for (const StagePlan& stage : make_plan(job)) EXPECT_EQ(stage.runs + stage.perhaps, 0U);
}

TEST(Stages, AreDoneInBatchesOfAGigabyteOfSceneFiles) {
  const std::vector<int> frames = {1, 2, 3, 5, 7, 8, 9, 10, 11};
  const std::vector<std::vector<int>> whole = {frames};
  EXPECT_EQ(batches_of(frames, 1e3), whole);
  const std::vector<std::vector<int>> halves = {{1, 2, 3, 5}, {7, 8, 9, 10, 11}};
  EXPECT_EQ(batches_of(frames, 150e6), halves);
  EXPECT_EQ(batches_of(frames, 9e9).size(), 3U) << "four frames at once, however large";
  EXPECT_TRUE(batches_of({}, 1e3).empty());
  EXPECT_DOUBLE_EQ(bytes_in_batches({.shared = 3e9, .own = 50e6}, 1000), 5e9);
  EXPECT_DOUBLE_EQ(bytes_in_batches({.shared = 3e9, .own = 50e6}, 10), 3.5e9);
}

// Its last job waits for all that nothing else waits for.
TEST(Stages, WithoutPicturesEndAJobTemplateWithTheSceneFiles) {
  Job job = job_of({&test::file_only_exporter()});
  job.out = "out";
  RenderOptions options;
  options.scene = "scene.toml";
  const std::string json = plan_openjd(options, job, make_plan(job));
  const std::size_t manifest = json.find("\"manifest\"");
  ASSERT_NE(manifest, std::string::npos);
  EXPECT_NE(json.find("\"dependsOn\": \"scenes\"", manifest), std::string::npos) << json;
}

}  // namespace
}  // namespace wold::work
