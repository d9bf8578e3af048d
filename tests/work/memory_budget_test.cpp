#include "work/memory_budget.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "film/exporters.h"
#include "support/temporary_folder.h"
#include "work/estimate.h"
#include "work/tasks.h"

namespace wold::work {
namespace {

// Beside a renderer there is the process that waits for it.
TEST(MemoryBudget, OfPicturesIsMoreThanTheRendererTakes) {
  const test::TemporaryFolder folder("memory_budget");
  Job job;
  job.scene.terrain.size_m = 6.0;
  job.scene.terrain.samples = 33;
  job.scene.grass.lods = {16};
  job.scene.grass.variants = 1;
  job.scene.camera.eye_m = {3.0, 0.5};
  job.scene.camera.target_m = {3.0, 4.0};
  job.scene.ageing.frames = {0.0};
  job.frames = {1};
  job.exporters = {film::exporters().front()};
  job.out = folder.path();
  const std::vector<StageTasks> pictures = {stages_of(job).back()};
  Work work(job);
  job.memory_bytes = memory_bytes(job, pictures.front(), work);
  EXPECT_THROW(require_memory(job, pictures), InputError);
  job.memory_bytes += 1e15;  // a sanitizer has much of the addresses
  EXPECT_NO_THROW(require_memory(job, pictures));
}

}  // namespace
}  // namespace wold::work
