#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <vector>

#include "compare/images.h"
#include "core/files.h"
#include "core/image.h"
#include "golden.h"
#include "support/places.h"

/// Every scene of examples/, made small: what ships works, and looks as it did.
namespace wold::test {
namespace {

const fs::path examples = tests_folder() / ".." / "examples";

/// All scene files, by their paths from the folder.
std::set<std::string> scenes() {
  std::set<std::string> paths;
  for (const auto& entry : fs::recursive_directory_iterator(examples))
    if (entry.path().extension() == ".toml")
      paths.insert(entry.path().lexically_relative(examples).string());
  return paths;
}

/// A resolved scene from the value of a key on.
std::string from_value(const std::string& scene, const std::string& table, const std::string& key) {
  const std::string start = fmt::format("\n{} = ", key);
  return scene.substr(scene.find(start, scene.find(fmt::format("\n[{}]", table))) + start.size());
}

/// A film's frame in the middle, where snow lies and clouds have come.
int middle_frame(const std::string& scene) {
  if (from_value(scene, "season", "first").front() == '[' &&
      from_value(scene, "season", "first")[1] != ']')
    return (std::stoi(from_value(scene, "season", "frames")) + 1) / 2;
  const std::string frames = from_value(scene, "ageing", "frames");
  return static_cast<int>(std::count(frames.begin(), frames.begin() + frames.find(']'), ',') + 2) /
         2;
}

/// As fine a ground as a small picture shows.
int ground_samples(const std::string& scene) {
  return std::min(std::stoi(from_value(scene, "terrain", "samples")), 129);
}

/// Scenes with large pictures, as they ship: levels of detail, variants, key frames, merged blades
/// and flakes can be seen in them. golden_test.cpp has those of hillside.toml.
const std::set<std::string> large = {
    "texel",      "texel_structure", "levels",  "key_frames", "mingling_b3",
    "snow_light", "snow_blizzard",   "evening", "mountain",   "two_grasses"};

/// The others are small: what they ship works and has its colours in its places.
std::string picture_options(const std::string& name, const std::string& scene) {
  if (large.contains(name)) return "--size 480x270 --samples 1";
  return fmt::format(
      "--size 96x54 --samples 1 --set 'grass.levels=[30]' --set grass.variants=1 "
      "--set terrain.samples={}",
      ground_samples(scene));
}

class Examples : public GoldenPictures, public testing::WithParamInterface<std::string> {};

TEST_P(Examples, AreNamedAfterTheirFileAndLookAsTheyDid) {
  for (const char* renderer : {"blender", "povray"})
    if (!can_render(renderer))
      GTEST_SKIP() << "no complete " << renderer << " on this machine: the examples are not tested";
  const std::string scene = " '" + (examples / GetParam()).string() + "' ";
  const Result checked = wold("check" + scene);
  ASSERT_EQ(checked.code, 0) << checked.err;
  const std::string name = fs::path(GetParam()).stem().string();
  expect_contains(checked.out, fmt::format("\nname = \"{}\"\n", name));
  expect_contains(read_file(examples / GetParam()), "wold render examples/" + GetParam());

  // Wold itself looks whether a picture has the right size and is not blank.
  const int frame = middle_frame(checked.out);
  const Result made = wold(fmt::format("render {} --quiet --out out --renderer both --frames {} {}",
                                       scene, frame, picture_options(name, checked.out)));
  ASSERT_EQ(made.code, 0) << made.err;
  for (const char* renderer : {"blender", "povray"})
    expect_golden(folder_ / fmt::format("out/frames/{}/{:04}.png", renderer, frame),
                  fmt::format("examples/{}_{}", name, renderer));
}

std::string test_name(const testing::TestParamInfo<std::string>& test) {
  return fs::path(test.param).stem().string();
}

INSTANTIATE_TEST_SUITE_P(All, Examples, testing::ValuesIn(scenes()), test_name);

TEST(GoldenPictures, BelongToAnExample) {
  std::set<std::string> names;
  for (const std::string& scene : scenes())
    for (const char* renderer : {"blender", "povray"})
      names.insert(fmt::format("{}_{}.png", fs::path(scene).stem().string(), renderer));
  for (const auto& entry : fs::directory_iterator(tests_folder() / "golden" / "examples"))
    EXPECT_TRUE(names.contains(entry.path().filename())) << entry.path() << " is of no example";
}

/// Scenes that differ have pictures that differ: else one of them shows nothing of what it is for.
TEST(GoldenPictures, OfScenesThatDifferDiffer) {
  for (const char* renderer : {"blender", "povray"}) {
    std::map<std::string, std::string> scene_of;
    for (const std::string& scene : scenes()) {
      const std::string name = fs::path(scene).stem().string();
      const fs::path picture =
          tests_folder() / "golden" / "examples" / fmt::format("{}_{}.png", name, renderer);
      const auto [known, is_new] = scene_of.emplace(read_file(picture), name);
      EXPECT_TRUE(is_new) << name << " and " << known->second << " have the same picture by "
                          << renderer;
    }
  }
}

/// Judges the pictures that ship, so that none made anew is wrong in one renderer alone: mean
/// difference after 8 x 8 means, half of what one look allows.
TEST_F(Program, GoldenPicturesShowTheSameFromBothRenderers) {
  const fs::path golden = tests_folder() / "golden" / "examples";
  for (const std::string& scene : scenes()) {
    const std::string name = fs::path(scene).stem().string();
    const auto picture = [&](const char* renderer) {
      return read_image(golden / fmt::format("{}_{}.png", name, renderer));
    };
    const auto metrics = compare::compare_images(picture("povray"), picture("blender"), 0.02);
    EXPECT_LT(255.0 * metrics.mean_abs_blurred8, 2.5) << name;
  }
}

// A piece of the San Gabriel Mountains. The model's cells around 29 m from its middle to the
// south-west and north-east say 1142 m and 1172 m; a cell is half as wide as the square.
TEST_F(Program, PutsTheMeadowOnARealMountain) {
  const fs::path model = tests_folder() / "data" / "terrain" / "bigtujunga_srtm30.tif";
  const std::string scene = " '" + (examples / "real_slope.toml").string() + "' ";
  const std::string options =
      "--quiet --out out --renderer blender --size 64x36 --set 'grass.levels=[30]' "
      "--set grass.variants=1 --set terrain.samples=33 --terrain '" +
      model.string() + "' --set 'terrain.centre=[";
  const Result made = wold("generate" + scene + options + "394000, 3798000]'");
  ASSERT_EQ(made.code, 0) << made.err;
  const std::string bytes = read_file(folder_ / "out/blender/data/frame_0001/heights_m.f32");
  std::vector<float> heights_m(33 * 33);
  ASSERT_EQ(bytes.size(), heights_m.size() * sizeof(float));
  std::memcpy(heights_m.data(), bytes.data(), bytes.size());
  EXPECT_NEAR(heights_m.back() - heights_m.front(), 1172 - 1142, 6.0);
  EXPECT_NEAR(*std::min_element(heights_m.begin(), heights_m.end()), 0.0, 1.0);
  const Result beside = wold("generate" + scene + options + "0, 0]'");
  EXPECT_EQ(beside.code, 2);
  expect_contains(beside.err, "the model reaches from 376313");
}

}  // namespace
}  // namespace wold::test
