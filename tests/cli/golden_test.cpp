#include "golden.h"

#include <fmt/format.h>

#include "support/places.h"

/// The pictures of examples/hillside.toml with the levels and variants that ship.
namespace wold::test {
namespace {

class GoldenHillside : public GoldenPictures {};

TEST_F(GoldenHillside, LooksAsItDid) {
  for (const char* renderer : {"blender", "povray"})
    if (!can_render(renderer))
      GTEST_SKIP() << "no complete " << renderer << " on this machine: no picture is compared";
  const Result made =
      wold(fmt::format("render '{}' --quiet --out out --renderer both"
                       " --size 480x270 --samples 1",
                       (tests_folder() / "../examples/hillside.toml").string()));
  ASSERT_EQ(made.code, 0) << made.err;
  for (const char* renderer : {"blender", "povray"})
    for (int frame = 1; frame <= 3; ++frame)
      expect_golden(folder_ / fmt::format("out/frames/{}/{:04}.png", renderer, frame),
                    fmt::format("hillside_{}_{:04}", renderer, frame));
}

}  // namespace
}  // namespace wold::test
