#include <set>

#include "core/files.h"
#include "program.h"

/// Every scene of examples/, made small: what ships works. The pictures of examples/hillside.toml
/// are compared in golden_test.cpp.
namespace wold::test {
namespace {

const fs::path examples = fs::path(WOLD_TESTS_DIR) / ".." / "examples";

/// All scene files, by their paths from the folder.
std::set<std::string> scenes() {
  std::set<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(examples))
    if (entry.path().extension() == ".toml")
      paths.insert(entry.path().lexically_relative(examples).string());
  return paths;
}

class Examples : public Program, public testing::WithParamInterface<std::string> {};

TEST_P(Examples, AreNamedAfterTheirFileAndMakeAPicture) {
  const std::string scene = " '" + (examples / GetParam()).string() + "' ";
  const Result checked = wold("check" + scene);
  ASSERT_EQ(checked.code, 0) << checked.err;
  expect_contains(checked.out, "\nname = \"" + fs::path(GetParam()).stem().string() + "\"\n");
  expect_contains(read_file(examples / GetParam()), "wold render examples/" + GetParam());

  // Wold itself looks whether a picture has the right size and is not blank.
  const Result made = wold("render" + scene +
                           "--quiet --out out --renderer both --frames 1 --size 64x36 --samples 1 "
                           "--set 'grass.levels=[30]' --set grass.variants=1 "
                           "--set terrain.samples=33");
  if (made.code == 3) GTEST_SKIP() << made.err;  // a renderer is not installed
  ASSERT_EQ(made.code, 0) << made.err;
  for (const char* file : {"out/frames/blender/0001.png", "out/frames/povray/0001.png"})
    EXPECT_TRUE(fs::exists(folder_ / file)) << file;
}

std::string test_name(const testing::TestParamInfo<std::string>& test) {
  return fs::path(test.param).stem().string();
}

INSTANTIATE_TEST_SUITE_P(All, Examples, testing::ValuesIn(scenes()), test_name);

}  // namespace
}  // namespace wold::test
