#include <gmock/gmock.h>
#include <sys/mount.h>

#include <csignal>

#include "core/files.h"
#include "small_film.h"

/// What can go wrong on the way, each with its exit code and a sentence that helps, nothing
/// half-written, and the same command going on afterwards.
namespace wold::test {
namespace {

class Failure : public SmallFilm {
 protected:
  static constexpr const char* render = "render small.toml --renderer blender --out out";
  static constexpr const char* generate = "generate small.toml --out out";

  void expect_failure(const Result& result, int code, const std::string& part) const {
    EXPECT_EQ(result.code, code);
    EXPECT_EQ(result.out, "");
    expect_contains(result.err, "error: ");
    expect_contains(result.err, part);
    expect_nothing_half_written("out");
  }

  /// What a run leaves that was killed: with it the folder is known as one of this program's.
  void leave_a_run() const {
    make_folder(folder_ / "out/tasks");
    write("out/tasks/lock", "");
  }

  /// The same command goes on and ends with what an undisturbed one makes.
  void expect_generate_goes_on(const std::string& options = "") const {
    const Result result = wold(generate + options);
    EXPECT_EQ(result.code, 0) << result.err;
    expect_nothing_half_written("out");
    EXPECT_EQ(wold("generate small.toml --out undisturbed" + options).code, 0);
    EXPECT_THAT(different(contents("out"), contents("undisturbed")), testing::IsEmpty());
  }
};

TEST_F(Failure, MissingRendererIsNamedBeforeAnythingIsMade) {
  expect_failure(wold(render, "PATH=/nowhere"), 3, "apt-get install blender");
  const Result named =
      wold("render small.toml --out out", "WOLD_POVRAY=/nowhere WOLD_BLENDER=/bin/true");
  expect_failure(named, 3, "WOLD_POVRAY names /nowhere");
  expect_contains(named.err, "apt-get install povray");
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_EQ(wold(generate, "PATH=/nowhere").code, 0) << "only render needs renderers";
}

// As a Blender that cannot show volumes does: it says that all is done. Grass as sparse as the
// small film's is hardly seen on its soil, so there is more of it.
TEST_F(Failure, PictureWithoutItsGrassIsNoPicture) {
  const std::string dense = std::string(render) + " --set grass.blades=150";
  const Result result =
      wold(dense, blender_played_by("[ $frame = 2 ] && paint without; cp $good \"$out\""));
  expect_failure(result, 3, "Blender failed on frame 2: its picture shows ");
  expect_contains(result.err, " % of the grass that should be there");
  expect_contains(result.err, "--grass blades");
  EXPECT_TRUE(fs::exists(folder_ / "out/frames/blender/0001.png"));
  EXPECT_FALSE(fs::exists(folder_ / "out/frames/blender/0002.png"));
  calls();
  EXPECT_EQ(wold(dense, blender_played_by("cp $good \"$out\"")).code, 0);
  EXPECT_EQ(calls(), "2 ") << "the first is done, the second never was";
}

TEST_F(Failure, KilledRendererNamesItsLogAndKeepsTheOtherPictures) {
  const std::string killed = blender_played_by(
      "[ $frame = 1 ] && cp $good \"$out\" && exit\n"
      "echo the last words; head -c 500 $good > \"$out\"; kill -KILL $$");
  const Result result = wold(render, killed);
  expect_failure(result, 3, "Blender failed on frame 2: killed by signal 9");
  expect_contains(result.err, "its log is out/logs/blender_0002.log");
  expect_contains(read_file(folder_ / "out/logs/blender_0002.log"), "the last words");
  EXPECT_TRUE(fs::exists(folder_ / "out/frames/blender/0001.png"));
  EXPECT_FALSE(fs::exists(folder_ / "out/frames/blender/0002.png"));
  calls();
  EXPECT_EQ(wold(render, blender_played_by("cp $good \"$out\"")).code, 0);
  EXPECT_EQ(calls(), "2 ");
}

TEST_F(Failure, ABlockedFolderIsAFileError) {
  // Files in the way of folders and a folder in the way of a file: they stop even root.
  const std::string blender = blender_played_by("cp $good \"$out\"");
  for (const std::string blocked : {"texels", "blender", "frames/blender", "logs"}) {
    leave_a_run();
    make_folder((folder_ / "out" / blocked).parent_path());
    write("out/" + blocked, "in the way");
    expect_failure(wold(render, blender), 4, "out/" + blocked);
    EXPECT_EQ(read_file(folder_ / "out" / blocked), "in the way");
    fs::remove(folder_ / "out" / blocked);
  }
  fs::remove_all(folder_ / "out");
  leave_a_run();
  make_folder(folder_ / "out/blender/data/frame_0002/sky.exr/in the way");
  expect_failure(wold(render, blender), 4, "out/blender/data/frame_0002/sky.exr");
  fs::remove_all(folder_ / "out/blender/data/frame_0002/sky.exr");
  EXPECT_EQ(wold(render, blender).code, 0);
}

TEST_F(Failure, AFileWhereTheOutputShouldGoIsAFileError) {
  write("out", "in the way");
  expect_failure(wold(generate), 4, "cannot create folder out: ");
  EXPECT_EQ(read_file(folder_ / "out"), "in the way");
}

/// A small disk, as long as it lives.
class Disk {
 public:
  explicit Disk(fs::path folder) : folder_(std::move(folder)) {
    make_folder(folder_);
    mounted_ = ::mount("none", folder_.c_str(), "tmpfs", 0, "size=4k") == 0;
  }
  ~Disk() {
    if (mounted_) ::umount(folder_.c_str());
  }
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;
  bool is_mounted() const { return mounted_; }
  void resize(int kilobytes) const {
    const std::string size = "size=" + std::to_string(kilobytes) + "k";
    ASSERT_EQ(::mount("none", folder_.c_str(), "tmpfs", MS_REMOUNT, size.c_str()), 0);
  }
  void make_read_only() const {
    ASSERT_EQ(::mount("none", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr), 0);
  }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

// Tasks are done without asking first whether the disk has room for the film.
TEST_F(Failure, FullDiskIsAFileErrorWhereverItHappens) {
  const Disk disk(folder_ / "out");
  if (!disk.is_mounted()) GTEST_SKIP() << "needs the right to mount a small disk";
  std::string tasks = "true";
  for (const std::string task : {"texels 1", "texels 2", "scenes 1", "scenes 2"})
    tasks += " && (" + command("task small.toml " + task + " --out out") + ")";
  // In the scene file, the texels, the volumes of Blender, those of POV-Ray and the second frame.
  for (const int kilobytes : {4, 500, 3000, 7000, 11000}) {
    disk.resize(kilobytes);
    expect_failure(shell(tasks), 4, "o space left on device");
  }
  disk.resize(100000);
  expect_generate_goes_on();
}

TEST_F(Failure, ADiskThatIsTooSmallIsRefusedBeforeAnythingIsWritten) {
  const Disk disk(folder_ / "out");
  if (!disk.is_mounted()) GTEST_SKIP() << "needs the right to mount a small disk";
  disk.resize(3000);
  expect_failure(wold(generate), 4, "no space left for out: found 4 MB free on its disk, expected");
  EXPECT_TRUE(files_below(folder_ / "out").empty());
  disk.resize(100000);
  expect_generate_goes_on();
}

TEST_F(Failure, AReadOnlyDiskIsAFileErrorAndCanBePlannedFrom) {
  const Disk disk(folder_ / "out");
  if (!disk.is_mounted()) GTEST_SKIP() << "needs the right to mount a small disk";
  disk.resize(100000);
  EXPECT_EQ(wold(generate).code, 0);
  fs::remove(folder_ / "out/texels/v0_k00_030.vdb");
  disk.make_read_only();
  expect_failure(wold(generate), 4, "cannot write out/tasks/lock: Read-only file system");
  expect_contains(wold("plan small.toml --why --out out").out, "texels/v0_k00_030.vdb is missing");
  disk.resize(100000);
  expect_generate_goes_on();
}

TEST_F(Failure, AFolderRemovedMeanwhileIsAnErrorAndTheSameCommandMakesIt) {
  const Result early = wold(render, blender_played_by("rm -rf out; exit 1"));
  EXPECT_NE(early.code, 0);
  expect_contains(early.err, "error: ");
  const Result late = wold(render, blender_played_by("cp $good \"$out\"; rm -rf out"));
  EXPECT_NE(late.code, 0);
  expect_contains(late.err, "error: ");
  const std::string sound = blender_played_by("cp $good \"$out\"");
  EXPECT_EQ(wold(render, sound).code, 0);
  EXPECT_EQ(wold("render small.toml --renderer blender --out undisturbed", sound).code, 0);
  EXPECT_THAT(different(contents("out"), contents("undisturbed")), testing::IsEmpty());
}

class Interrupt : public Failure {
 protected:
  void expect_interrupted(Running& program) const {
    program.send(SIGINT);
    const Result result = program.finish();
    EXPECT_EQ(result.code, 130) << result.err;
    EXPECT_EQ(result.out, "");
    expect_contains(result.err, "interrupted; the same command goes on where it stopped");
    expect_nothing_half_written("out");
  }
};

TEST_F(Interrupt, InTheTexels) {
  const std::string options = slower;
  const fs::path texels = folder_ / "out/texels";
  Running program(folder_, command(generate + options));
  ASSERT_TRUE(eventually([&] { return fs::exists(texels / "v0_k00_062.vdb"); }));
  expect_interrupted(program);
  EXPECT_FALSE(fs::exists(texels / "v1_k02_062.vdb")) << "it was over already";
  const auto first = fs::last_write_time(texels / "v0_k00_062.vdb");
  expect_generate_goes_on(options);
  EXPECT_EQ(fs::last_write_time(texels / "v0_k00_062.vdb"), first);
}

TEST_F(Interrupt, InTheSceneFiles) {
  Running program(folder_, command(generate));
  ASSERT_TRUE(eventually([&] { return fs::exists(folder_ / "out/povray/scene.pov"); }));
  expect_interrupted(program);
  expect_generate_goes_on();
}

TEST_F(Interrupt, InARendererEndsItAndItsChildren) {
  const std::string busy = blender_played_by(
      "[ $frame = 1 ] && cp $good \"$out\" && exit\n"
      "head -c 500 $good > \"$out\"; sleep 600 & echo $! > child; echo $$ > new; mv new parent; "
      "wait");
  Running program(folder_, command(render, busy));
  ASSERT_TRUE(eventually([&] { return fs::exists(folder_ / "parent"); }));
  expect_interrupted(program);
  EXPECT_TRUE(is_gone(folder_ / "parent"));
  EXPECT_TRUE(is_gone(folder_ / "child"));
  EXPECT_TRUE(fs::exists(folder_ / "out/frames/blender/0001.png"));
  EXPECT_FALSE(fs::exists(folder_ / "out/frames/blender/0002.png"));
  calls();
  EXPECT_EQ(wold(render, blender_played_by("cp $good \"$out\"")).code, 0);
  EXPECT_EQ(calls(), "2 ");
}

}  // namespace
}  // namespace wold::test
