#include "render/probe.h"

#include <gmock/gmock.h>

#include <thread>

#include "core/error.h"
#include "fake_renderer.h"
#include "povray/renderer.h"
#include "render/probe_cache.h"
#include "support/fake_blender.h"

/// What renderers say that they can show, and how that is kept.
namespace wold::test {
namespace {

using render::Capabilities;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Probe : public FakeRenderer {
 protected:
  Probe() {
    make_folder(folder_ / "package");
    write_file(folder_ / "package/wold_render.py", "print()\n");
    ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    say({});
  }
  ~Probe() override { ::unsetenv("XDG_CACHE_HOME"); }

  void say(const FakeBlender& fake) const {
    write_program("fake.sh", fake_blender_head((folder_ / "probes").string(), fake));
  }

  render::RendererProgram program() const {
    render::RendererProgram program = fake_program();
    program.launcher = folder_ / "package/wold_render.py";
    return program;
  }

  render::ProbeAnswer once() const { return render::probe_once(program(), never); }

  fs::path kept() const { return fs::directory_iterator(folder_ / "cache/wold")->path(); }

  std::string failure() const {
    try {
      render::probe(program(), never);
    } catch (const RendererError& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(Probe, ReadsEverythingThatBlenderSays) {
  say({"5.2.2", false, true, R"([{"type": "CUDA", "name": "Card \"7\""}])"});
  const Capabilities can = render::probe(program(), never);
  EXPECT_EQ(can.version, "5.2.2");
  EXPECT_EQ(can.python, "3.99");
  EXPECT_FALSE(can.volumes);
  EXPECT_TRUE(can.fog);
  EXPECT_EQ(can.nanovdb, std::nullopt);
  EXPECT_EQ(can.devices, (std::vector<render::Device>{{"CUDA", "Card \"7\""}}));
  EXPECT_EQ(can.threads, 2);
}

TEST_F(Probe, WithoutAnAnswerSaysWhatWasFound) {
  play("echo no such module; exit 7");
  EXPECT_THAT(failure(),
              AllOf(HasSubstr("Blender 9.9.9 (" + folder_.string()), HasSubstr("exit code 7"),
                    HasSubstr("no such module"), HasSubstr("name another build by --blender")));
  play("echo 'wold: probe {\"volumes\": 1}'");
  EXPECT_THAT(failure(), HasSubstr("does not say what it can show"));
  play("echo 'wold: probe {'");
  EXPECT_THAT(failure(), HasSubstr("does not say what it can show"));
  play("true");
  EXPECT_THAT(failure(), HasSubstr("does not say what it can show"));
}

TEST_F(Probe, IsKeptAndGivenBackWhole) {
  say({"9.9.9", true, false, R"([{"type": "HIP", "name": "é"}])"});
  const render::ProbeAnswer first = once();
  const render::ProbeAnswer second = once();
  EXPECT_TRUE(first.is_new);
  EXPECT_FALSE(second.is_new);
  EXPECT_EQ(second.capabilities, first.capabilities);
  EXPECT_EQ(read_file(folder_ / "probes"), "probe\n");
}

TEST_F(Probe, IsMadeAgainForAnotherProgramVersionOrQuestion) {
  once();
  render::RendererProgram newer = program();
  newer.version = "10.0.0";
  EXPECT_TRUE(render::probe_once(newer, never).is_new);
  make_folder(folder_ / "package/__pycache__");
  write_file(folder_ / "package/__pycache__/wold_render.pyc", "byte code");
  EXPECT_FALSE(once().is_new) << "byte code is no other question";
  write_file(folder_ / "package/wold_render.py", "print(1)\n");
  EXPECT_TRUE(once().is_new);
  EXPECT_FALSE(once().is_new);
  fs::last_write_time(folder_ / "fake.sh",
                      fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_TRUE(once().is_new);
  render::RendererProgram module = program();
  module.module = folder_ / "good.png";
  EXPECT_TRUE(render::probe_once(module, never).is_new);
}

TEST_F(Probe, DamagedCacheIsAskedAnewAndMended) {
  const Capabilities said = once().capabilities;
  const std::string whole = read_file(kept());
  for (const std::string& damaged : {std::string(), whole.substr(0, whole.size() / 2),
                                     std::string("[]"), std::string("{\"key\": 1}")}) {
    write_file(kept(), damaged);
    EXPECT_EQ(once().capabilities, said) << damaged;
    EXPECT_EQ(read_file(kept()), whole) << damaged;
  }
}

TEST_F(Probe, ACacheThatCannotBeWrittenDoesNoHarm) {
  write_file(folder_ / "cache", "in the way");
  EXPECT_TRUE(once().is_new);
  EXPECT_TRUE(once().is_new);
  ::setenv("XDG_CACHE_HOME", "not/absolute", 1);
  const std::string home = std::getenv("HOME");
  ::setenv("HOME", folder_.c_str(), 1);
  EXPECT_EQ(render::probe_cache_folder(), folder_ / ".cache/wold");
  ::unsetenv("HOME");
  EXPECT_EQ(render::probe_cache_folder(), std::nullopt);
  EXPECT_TRUE(once().is_new);
  ::setenv("HOME", home.c_str(), 1);
}

TEST_F(Probe, ManyProcessesMayAskAtOnce) {
  std::vector<std::thread> askers;
  for (int i = 0; i < 8; ++i)
    askers.emplace_back([this] { EXPECT_TRUE(once().capabilities.volumes); });
  for (std::thread& asker : askers) asker.join();
  EXPECT_FALSE(once().is_new);
}

/// POV-Ray itself; skipped aloud where it is missing.
class PovrayProbe : public FakeRenderer {
 protected:
  void SetUp() override {
    try {
      const auto found = render::find_renderer(povray::renderer());
      program_ = render::recognise(povray::renderer(), found, never);
    } catch (const RendererError& error) {
      GTEST_SKIP() << error.what();
    }
  }
  render::RendererProgram program_;
};

TEST_F(PovrayProbe, SeesTheVoxelAndTheFog) {
  const Capabilities can = render::probe(program_, never);
  EXPECT_TRUE(can.volumes);
  EXPECT_TRUE(can.fog);
  EXPECT_THAT(can.version, ::testing::StartsWith("3."));
}

// A program that takes the scene, and leaves out what is to be seen on the left.
TEST_F(PovrayProbe, MissesAVoxelThatIsNotDrawn) {
  const fs::path real = program_.found.path;
  program_.found.path =
      write_program("without.sh", "#!/bin/sh\nsed -i '/Voxel } }/d' probe.pov\nexec '" +
                                      real.string() + "' \"$@\"\n");
  const Capabilities can = render::probe(program_, never);
  EXPECT_FALSE(can.volumes);
  EXPECT_TRUE(can.fog);
}

}  // namespace
}  // namespace wold::test
