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

// A piece of the San Gabriel Mountains.
TEST_F(Program, PutsTheMeadowOnARealMountain) {
  const fs::path model = fs::path(WOLD_TESTS_DIR) / ".." / ".." / "shared" / "data" / "terrain" /
                         "bigtujunga_srtm30.tif";
  if (!fs::exists(model)) GTEST_SKIP() << model << " is not there: no real mountain is tested";
  const std::string scene = " '" + (examples / "real_slope.toml").string() + "' ";
  const std::string options =
      "--quiet --out out --renderer povray --size 64x36 --set 'grass.levels=[30]' "
      "--set grass.variants=1 --set terrain.samples=33 --terrain '" +
      model.string() + "' --set 'terrain.centre=[";
  const Result made = wold("generate" + scene + options + "394000, 3798000]'");
  ASSERT_EQ(made.code, 0) << made.err;
  const Result beside = wold("generate" + scene + options + "0, 0]'");
  EXPECT_EQ(beside.code, 2);
  expect_contains(beside.err, "the model reaches from 376313");
}

}  // namespace
}  // namespace wold::test
