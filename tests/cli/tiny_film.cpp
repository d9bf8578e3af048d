#include "tiny_film.h"

#include <gmock/gmock.h>

namespace wold::test {

void TinyFilm::SetUp() {
  SmallFilm::SetUp();
  if (!is_installed("povray")) GTEST_SKIP() << "no povray on this machine";
  write("tiny.toml", R"(name = "tiny"
seed = 3
terrain = { size = 4, samples = 33 }
grass = { blades = 20, variants = 1, levels = [30], key_frames = [0.0, 1.0] }
ageing = { frames = [0.1, 0.5, 0.8] }
camera = { eye = [2, 0.5], target = [2, 1.2], target_height = 0 }
render = { renderer = "povray", size = [32, 18], samples = 1 }
)");
  const Result result = shell(render_line("undisturbed"));
  ASSERT_EQ(result.code, 0) << result.err;
  undisturbed_ = contents("undisturbed");
}

void TinyFilm::expect_goes_on(const std::string& out) const {
  const Result result = shell(render_line(out));
  EXPECT_EQ(result.code, 0) << result.err;
  expect_undisturbed(out);
}

void TinyFilm::expect_undisturbed(const std::string& out) const {
  EXPECT_THAT(different(contents(out), undisturbed_), testing::IsEmpty());
  expect_nothing_half_written(out);
}

}  // namespace wold::test
