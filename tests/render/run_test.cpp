#include "render/run.h"

#include <gmock/gmock.h>
#include <sys/mount.h>

#include "core/error.h"
#include "fake_renderer.h"

namespace wold::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class CountingProgress final : public Progress {
 public:
  void begin(std::string_view, std::size_t units) override { units_ = units; }
  void advance(std::size_t units, std::string_view) override { steps_.push_back(units); }
  void end() override { ended_ = true; }
  void say(std::string_view) override {}
  std::size_t units_ = 0;
  std::vector<std::size_t> steps_;
  bool ended_ = false;
};

/// Whether a process has ended, be it collected or not.
bool runs(const std::string& pid) {
  std::ifstream stat("/proc/" + pid + "/stat");
  const std::string text{std::istreambuf_iterator<char>(stat), {}};
  return !text.empty() && text.find(") Z ") == std::string::npos;
}

/// Whether the process ends; one that was killed may need a moment on a busy machine.
bool is_gone(const fs::path& pid_file) {
  std::string pid = read_file(pid_file);
  pid.erase(pid.find_last_not_of('\n') + 1);
  for (int tenth = 0; tenth < 50 && runs(pid); ++tenth)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return !runs(pid);
}

TEST_F(FakeRenderer, MakesThePictureReportsProgressAndKeepsTheLog) {
  play(
      "echo hello; echo 'wold: progress 0.25'; echo 'wold: progress 0.5' >&2; cp "
      "\"$folder/good.png\" \"$out\"");
  CountingProgress progress;
  render::run(job(), progress, never);
  EXPECT_EQ(read_file(job().picture), read_file(folder_ / "good.png"));
  EXPECT_EQ(progress.units_, 100U);
  EXPECT_EQ(progress.steps_, (std::vector<std::size_t>{25, 25, 50}));
  EXPECT_TRUE(progress.ended_);
  EXPECT_THAT(read_file(job().log), AllOf(HasSubstr("hello\n"), Not(HasSubstr("wold: progress"))));
}

TEST_F(FakeRenderer, ProgressNeverGoesBack) {
  play(
      "for x in 0.5 0.25 0.5 0.75; do echo \"wold: progress $x\"; done; cp \"$folder/good.png\" "
      "\"$out\"");
  CountingProgress progress;
  render::run(job(), progress, never);
  EXPECT_EQ(progress.steps_, (std::vector<std::size_t>{50, 25, 25}));
}

// Renderers note when they made a picture, and how long it took.
TEST_F(FakeRenderer, OfAPictureOnlyThePixelsAreKept) {
  // After the signature and IHDR (8 + 25 bytes) comes a text chunk: "Date" and when.
  play(
      "{ head -c 33 \"$folder/good.png\"; "
      "printf '\\000\\000\\000\\014tEXtDate\\0001999-12\\011\\212\\200\\044'; "
      "tail -c +34 \"$folder/good.png\"; } > \"$out\"");
  SilentProgress progress;
  render::run(job(), progress, never);
  EXPECT_EQ(read_file(job().picture), read_file(folder_ / "good.png"));
}

TEST_F(FakeRenderer, AnOlderPictureDoesNotOutliveAFailure) {
  make_folder(job().picture.parent_path());
  write_image(job().picture, gradient(32, 18), PixelFormat::uint8);
  play("exit 1");
  failure_of<RendererError>(job());
}

TEST_F(FakeRenderer, NonZeroExitNamesFrameReasonLogAndLastLines) {
  play("echo first; echo 'no such texel' >&2; cp \"$folder/good.png\" \"$out\"; exit 7");
  EXPECT_THAT(failure_of<RendererError>(job()),
              AllOf(HasSubstr("Blender"), HasSubstr("frame 3"), HasSubstr("exit code 7"),
                    HasSubstr(job().log.string()), HasSubstr("no such texel")));
}

TEST_F(FakeRenderer, DeathBySignalIsNamed) {
  play("kill -SEGV $$");
  EXPECT_THAT(failure_of<RendererError>(job()), HasSubstr("signal 11 (Segmentation fault)"));
}

TEST_F(FakeRenderer, GetsAsMuchMemoryAsItIsAllowed) {
  play("x=$(head -c 60000000 /dev/zero | tr '\\0' x); sleep 0.5; cp \"$folder/good.png\" \"$out\"");
  SilentProgress progress;
  render::Job greedy = job();
  EXPECT_GT(render::run(greedy, progress, never), 60e6);
  greedy.memory_bytes = 40e6;
  EXPECT_THAT(failure_of<RendererError>(greedy), HasSubstr("it was allowed 40 MB of memory"));
}

TEST_F(FakeRenderer, TimeOutEndsEvenWhatIgnoresIt) {
  play(
      "trap '' TERM; sleep 60 & echo $! > \"$folder/pid\"; echo half > \"$out\"; while :; do wait; "
      "done");
  render::Job slow = job();
  slow.timeout = std::chrono::seconds(1);
  EXPECT_THAT(failure_of<RendererError>(slow), HasSubstr("no picture after 1 s"));
  EXPECT_TRUE(is_gone(folder_ / "pid"));
}

TEST_F(FakeRenderer, InterruptEndsTheProgramAndItsChildren) {
  play(
      "echo half > \"$out\"; echo state > \"${out%.png}.state\"; sleep 60 & echo $! > "
      "\"$folder/new\"; "
      "mv \"$folder/new\" \"$folder/pid\"; wait");
  render::Renderer with_state = blender::renderer();
  with_state.state_extension = ".state";
  render::Job stopped = job();
  stopped.program.kind = &with_state;
  failure_of<InterruptedError>(stopped, [&] { return fs::exists(folder_ / "pid"); });
  EXPECT_TRUE(is_gone(folder_ / "pid"));
}

TEST_F(FakeRenderer, AProgressSinkCanStopTheWork) {
  class Stopper final : public Progress {
    void begin(std::string_view, std::size_t) override {}
    void advance(std::size_t, std::string_view) override { throw InterruptedError(); }
    void end() override {}
    void say(std::string_view) override {}
  } progress;
  play("echo 'wold: progress 0.5'; sleep 60");
  EXPECT_THROW(render::run(job(), progress, never), InterruptedError);
}

TEST_F(FakeRenderer, DetachedChildrenDoNotHoldTheRunUp) {
  play("sleep 60 & cp \"$folder/good.png\" \"$out\"");
  SilentProgress progress;
  const auto start = std::chrono::steady_clock::now();
  render::run(job(), progress, never);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST_F(FakeRenderer, BlenderIsStartedFarFromTheDataAndToldWhereTheyAre) {
  write_program("fake.sh", "#!/bin/sh\npwd\necho \"$@\"\nexit 1\n");
  render::Job gpu = job();
  gpu.device = "gpu";
  const std::string said = failure_of<RendererError>(gpu);
  EXPECT_THAT(said, HasSubstr("\n    /\n"));
  EXPECT_THAT(said, HasSubstr("-b --factory-startup --python-exit-code 1 -P " +
                              (folder_ / "launcher.py").string() + " -- " +
                              (folder_ / "scene").string() + " 3 --out "));
  EXPECT_THAT(said, HasSubstr(" --size 32x18 --samples 4 --device gpu --threads 1\n"));
}

TEST_F(FakeRenderer, BlankPictureIsRefused) {
  Image blank(32, 18, 3);
  for (std::size_t i = 0; i < blank.values.size(); ++i)
    blank.values[i] = (i % 3 == 0 ? 0.2F : 0.8F) + (i % 2 == 0 ? 1.0F / 255.0F : 0.0F);  // dithered
  write_image(folder_ / "blank.png", blank, PixelFormat::uint8);
  play("cp \"$folder/blank.png\" \"$out\"");
  EXPECT_THAT(failure_of<RendererError>(job()), HasSubstr("blank"));
}

TEST_F(FakeRenderer, WrongSizeNamesBothSizes) {
  for (const glm::ivec2 size : {glm::ivec2(16, 9), glm::ivec2(32, 9), glm::ivec2(16, 18)}) {
    write_image(folder_ / "small.png", gradient(size.x, size.y), PixelFormat::uint8);
    play("cp \"$folder/small.png\" \"$out\"");
    EXPECT_THAT(
        failure_of<RendererError>(job()),
        HasSubstr(std::to_string(size.x) + " x " + std::to_string(size.y) + " pixels, 32 x 18"));
  }
}

TEST_F(FakeRenderer, NoPictureAndHalfAPictureAreRefused) {
  play("true");
  EXPECT_THAT(failure_of<RendererError>(job()), HasSubstr("wrote no picture"));
  play("head -c 100 \"$folder/good.png\" > \"$out\"");
  EXPECT_THAT(failure_of<RendererError>(job()), HasSubstr("damaged"));
}

TEST_F(FakeRenderer, ValuesThatAreNoNumbersAreRefused) {
  Image image = gradient(32, 18);
  image.values[7] = std::nanf("");
  write_image(folder_ / "nan.exr", image, PixelFormat::float32);
  play("cp \"$folder/nan.exr\" \"$out\"");
  render::Job exr = job();
  exr.picture.replace_extension(".exr");
  EXPECT_THAT(failure_of<RendererError>(exr), HasSubstr("not finite"));
}

TEST_F(FakeRenderer, UnwritableFolderIsAFileErrorBeforeTheRendererStarts) {
  play("touch \"$folder/started\"");
  render::Job blocked = job();
  blocked.picture = folder_ / "good.png" / "0003.png";  // below a file: fails for root too
  failure_of<FileError>(blocked);
  EXPECT_FALSE(fs::exists(folder_ / "started"));
}

TEST_F(FakeRenderer, FullDiskIsAFileError) {
  const fs::path disk = folder_ / "out";
  make_folder(disk);
  if (::mount("none", disk.c_str(), "tmpfs", 0, "size=256k") != 0)
    GTEST_SKIP() << "needs the right to mount a small disk";
  play("cat /dev/zero > \"$out\"");
  EXPECT_THAT(failure_of<FileError>(job()), HasSubstr("no space left"));
  ::umount(disk.c_str());
}

}  // namespace
}  // namespace wold::test
