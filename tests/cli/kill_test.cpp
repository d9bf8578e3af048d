#include <csignal>
#include <random>
#include <sstream>
#include <thread>

#include "core/files.h"
#include "tiny_film.h"

/// SIGKILL at any moment: nothing that looks whole is not, nobody goes on, and the same command
/// ends with what an undisturbed one makes. tests/benchmark/soak.sh does the same hundreds of
/// times.
namespace wold::test {
namespace {

using std::chrono::milliseconds;

class Killed : public TinyFilm {
 protected:
  /// A moment within `max`, another one each time, the same in every run of the test.
  void wait_at_most(milliseconds max) {
    std::this_thread::sleep_for(milliseconds(random_() % static_cast<unsigned>(max.count())));
  }

  milliseconds time_of_a_run() const {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(shell(render_line("timed")).code, 0);
    return std::chrono::duration_cast<milliseconds>(std::chrono::steady_clock::now() - start);
  }

  std::mt19937 random_{7};
};

TEST_F(Killed, AtRandomMomentsItGoesOnEachTime) {
  const milliseconds whole = time_of_a_run();
  for (int kill = 0; kill < 14; ++kill) {
    Running program(folder_, render_line("out"));
    wait_at_most(whole);
    program.send(SIGKILL);
    if (program.finish().code != 0) continue;
    expect_undisturbed("out");  // it was quicker
    fs::remove_all(folder_ / "out");
  }
  expect_goes_on("out");
}

TEST_F(Killed, RenderersAtRandomMomentsAreNamedAndTheirPicturesMadeAgain) {
  for (int kill = 0; kill < 6; ++kill) {
    fs::remove_all(folder_ / "out/frames");
    Running program(folder_, render_line("out"));
    int renderer = 0;
    ASSERT_TRUE(eventually([&] { return (renderer = program.child()) != 0; }));
    wait_at_most(milliseconds(60));
    ::kill(renderer, SIGKILL);
    const Result result = program.finish();
    if (result.code == 0) continue;  // it was quicker
    EXPECT_EQ(result.code, 3);
    expect_contains(result.err, "killed by signal 9");
    expect_nothing_half_written("out");
  }
  expect_goes_on("out");
}

TEST_F(Killed, ItTakesItsRendererWithIt) {
  write("fake.sh",
        "#!/bin/sh\ncase \"$*\" in *--version*|*probe.pov*) exec povray \"$@\" ;; esac\n"
        "echo $$ > pid.new; mv pid.new '" +
            (folder_ / "pid").string() + "'; exec sleep 600\n");
  fs::permissions(folder_ / "fake.sh", fs::perms::owner_all);
  Running program(folder_,
                  render_line("out", "WOLD_POVRAY='" + (folder_ / "fake.sh").string() + "'"));
  ASSERT_TRUE(eventually([&] { return fs::exists(folder_ / "pid"); }));
  program.send(SIGKILL);
  EXPECT_EQ(program.finish().code, -1);
  EXPECT_TRUE(eventually([&] { return is_gone(folder_ / "pid"); }));
  fs::remove(folder_ / "out/povray/pid.new");
  expect_goes_on("out");
}

}  // namespace
}  // namespace wold::test
