#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <string>

#include "core/files.h"
#include "povray/renderer.h"
#include "render/command.h"
#include "render/job.h"
#include "support/sanitized.h"

namespace wold::povray {
namespace {

// Rays that graze a meadow pass more surfaces than 4 MiB last for. No small scene of boxes shows
// it: POV-Ray 3.7 takes so much for volumes of df3 files in sight of a wide picture.
TEST(DeepStack, IsGivenToThreadsThatAskForLess) {
  const std::string library = shipped_library("deep_stack").string();
  if (test::sanitized) GTEST_SKIP() << "sanitized builds have none";
  void* loaded = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(loaded, nullptr) << ::dlerror();
  using SetStackSize = int (*)(pthread_attr_t*, std::size_t);
  const auto set_stack_size =
      reinterpret_cast<SetStackSize>(::dlsym(loaded, "pthread_attr_setstacksize"));
  ASSERT_NE(set_stack_size, nullptr);
  const auto given = [&](std::size_t asked_bytes) {
    pthread_attr_t attributes;
    std::size_t bytes = 0;
    EXPECT_EQ(::pthread_attr_init(&attributes), 0);
    EXPECT_EQ(set_stack_size(&attributes, asked_bytes), 0);
    EXPECT_EQ(::pthread_attr_getstacksize(&attributes, &bytes), 0);
    ::pthread_attr_destroy(&attributes);
    return bytes;
  };
  EXPECT_EQ(given(std::size_t{4} << 20U), std::size_t{32} << 20U);
  EXPECT_EQ(given(std::size_t{64} << 20U), std::size_t{64} << 20U);
  ::dlclose(loaded);
}

TEST(DeepStack, IsPreloadedIntoPovRay) {
  const std::string library = shipped_library("deep_stack").string();
  if (test::sanitized) GTEST_SKIP() << "sanitized builds have none";
  render::Job job;
  job.program.found.path = "/usr/bin/povray";
  job.scene_folder = "/tmp";
  const std::vector<std::string> arguments = renderer().command(job, "/tmp/picture.png").arguments;
  ASSERT_GT(arguments.size(), 3U);
  EXPECT_EQ(arguments[1], "LD_PRELOAD=" + library);
  EXPECT_EQ(arguments[2], "/usr/bin/povray");
  job.memory_bytes = 1e9;  // stacks of threads would count
  EXPECT_EQ(renderer().command(job, "/tmp/picture.png").arguments.front(), "/usr/bin/povray");
}

}  // namespace
}  // namespace wold::povray
