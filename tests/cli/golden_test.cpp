#include "golden.h"

#include <fmt/format.h>

/// The pictures of examples/hillside.toml, large enough to see its levels of detail.
namespace wold::test {
namespace {

class Golden : public GoldenPictures, public testing::WithParamInterface<std::string> {};

TEST_P(Golden, LooksAsItDid) {
  if (!can_render(GetParam()))
    GTEST_SKIP() << "no complete " << GetParam()
                 << " on this machine: its pictures are not compared";
  const Result made = wold("render '" WOLD_TESTS_DIR
                           "/../examples/hillside.toml' --out out"
                           " --size 240x136 --samples 4 --set 'grass.levels=[126, 62, 30]'"
                           " --renderer " +
                           GetParam());
  ASSERT_EQ(made.code, 0) << made.err;
  for (int frame = 1; frame <= 3; ++frame)
    expect_golden(folder_ / fmt::format("out/frames/{}/{:04}.png", GetParam(), frame),
                  fmt::format("hillside_{}_{:04}", GetParam(), frame));
}

INSTANTIATE_TEST_SUITE_P(Both, Golden, testing::Values("blender", "povray"),
                         [](const auto& test) { return "hillside_" + test.param; });

}  // namespace
}  // namespace wold::test
