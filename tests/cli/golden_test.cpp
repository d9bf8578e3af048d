#include <cstdlib>

#include "program.h"

/// The pictures of examples/hillside.toml, small, against those in tests/golden. To make these anew
/// after a change that is meant to be seen, and then look at them:
///
///   UPDATE_GOLDEN=1 build/test_cli --gtest_filter='*Golden*'
namespace wold::test {
namespace {

constexpr int frames = 3;

class Golden : public Program, public testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    Program::SetUp();
    if (!is_installed(GetParam()))
      GTEST_SKIP() << "no " << GetParam() << " on this machine: its pictures are not compared";
  }

  void render() const {
    const Result result = wold("render '" WOLD_TESTS_DIR
                               "/../examples/hillside.toml' --out out"
                               " --size 240x136 --samples 4 --set 'grass.levels=[126, 62, 30]'"
                               " --renderer " +
                               GetParam());
    ASSERT_EQ(result.code, 0) << result.err;
  }

  fs::path got(int frame) const {
    return folder_ / "out/frames" / GetParam() / ("000" + std::to_string(frame) + ".png");
  }
  std::string name(int frame) const {
    return "hillside_" + GetParam() + "_000" + std::to_string(frame);
  }
  fs::path want(int frame) const {
    return fs::path(WOLD_TESTS_DIR) / "golden" / (name(frame) + ".png");
  }

  /// Both pictures and their difference stay in the build folder when they are not the same.
  void compare(int frame) const {
    const fs::path evidence = fs::path(WOLD_BUILD_DIR) / "golden_evidence" / name(frame);
    const Result result = wold("compare '" + got(frame).string() + "' '" + want(frame).string() +
                               "' --report '" + evidence.string() + "'");
    EXPECT_EQ(result.code, 0) << "see " << evidence.string() << "\n" << result.out << result.err;
    if (result.code == 0) fs::remove_all(evidence);
  }
};

TEST_P(Golden, HillsideLooksAsItDid) {
  render();
  if (HasFatalFailure()) return;
  if (std::getenv("UPDATE_GOLDEN") == nullptr) {
    for (int frame = 1; frame <= frames; ++frame) compare(frame);
    return;
  }
  for (int frame = 1; frame <= frames; ++frame)
    fs::copy_file(got(frame), want(frame), fs::copy_options::overwrite_existing);
  GTEST_SKIP() << "made anew, nothing was compared";
}

INSTANTIATE_TEST_SUITE_P(Both, Golden, testing::Values("blender", "povray"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace wold::test
