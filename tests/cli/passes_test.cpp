#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/image.h"
#include "core/layered_image.h"
#include "passes/pass.h"
#include "small_film.h"

/// The ground truth of a film, with its pictures and without them.
namespace wold::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class PassesOfAFilm : public SmallFilm {
 protected:
  Result passes(const std::string& options = "") const {
    return wold("passes small.toml --quiet " + options);
  }
  std::string bytes(const std::string& out, int frame) const {
    return read_file(folder_ / out / fmt::format("passes/{:04}.exr", frame));
  }
};

TEST_F(PassesOfAFilm, AreMadeWithoutAnyRenderer) {
  const Result result = passes("--out out");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out, "out/passes/0001.exr\nout/passes/0002.exr\n");
  EXPECT_FALSE(fs::exists(folder_ / "out/blender"));
  EXPECT_FALSE(fs::exists(folder_ / "out/frames"));
  expect_nothing_half_written("out");
  const LayeredImage image = read_layered_image(folder_ / "out/passes/0002.exr");
  EXPECT_EQ(image.width, 64);
  EXPECT_EQ(image.height, 36);
  for (const passes::PassFacts& facts : passes::all_passes())
    EXPECT_EQ(image.attributes.count("wold/" + std::string(facts.name)), 1U) << facts.name;
  EXPECT_EQ(image.attributes.at("wold/frame"), "2");
  const auto manifest = json::parse(image.attributes.at("cryptomatte/57eb4ca/manifest"));
  EXPECT_EQ(manifest.size(), 3U);
  EXPECT_TRUE(manifest.contains("grass"));
}

// And with it the blur changes nothing that is made already.
TEST_F(PassesOfAFilm, OfAFilmWithAShutterAreThoseOfItsBlur) {
  const std::string generate = "generate small.toml --quiet --renderer povray --out out ";
  const Result made = wold(generate + "--set film.shutter=0.5");
  ASSERT_EQ(made.code, 0) << made.err;
  const LayeredImage image = read_layered_image(folder_ / "out/passes/0001.exr");
  EXPECT_NE(image.find("depth.Z"), nullptr);
  EXPECT_NE(image.find("motion.X"), nullptr);
  EXPECT_EQ(image.find("normal.X"), nullptr);
  const Result again = wold(generate + "--set film.shutter=0.25 --dry-run --json");
  ASSERT_EQ(again.code, 0) << again.err;
  for (const json& stage : json::parse(again.out)["stages"]) EXPECT_EQ(stage["runs"], 0) << stage;
  EXPECT_EQ(wold(generate + "--set film.shutter=0.5 --grass points --dry-run").code, 2);
  ASSERT_EQ(passes("--renderer povray --out out --set film.shutter=0.5").code, 0);
  ASSERT_EQ(wold(generate + "--set film.shutter=0.5").code, 0);  // which takes nothing away
  EXPECT_NE(read_layered_image(folder_ / "out/passes/0001.exr").find("normal.X"), nullptr);
}

TEST_F(PassesOfAFilm, AreTheSameBytesBesidePicturesAndAsTasks) {
  ASSERT_EQ(passes("--out alone --threads 1").code, 0);
  const std::string fake = blender_played_by("cp $good \"$out\"");
  const std::string options = " small.toml --renderer blender --passes all --quiet ";
  const Result rendered = wold("render" + options + "--out beside", fake);
  ASSERT_EQ(rendered.code, 0) << rendered.err;
  EXPECT_EQ(rendered.out,
            "beside/frames/blender/0001.png\nbeside/frames/blender/0002.png\n"
            "beside/passes/0001.exr\nbeside/passes/0002.exr\n");
  for (const std::string task : {"texels 1", "texels 2", "passes 2", "passes 1"}) {
    const Result done =
        wold(fmt::format("task small.toml {} --passes all --quiet --out farm", task));
    ASSERT_EQ(done.code, 0) << task << done.err;
  }
  for (const int frame : {1, 2}) {
    EXPECT_EQ(bytes("beside", frame), bytes("alone", frame));
    EXPECT_EQ(bytes("farm", frame), bytes("alone", frame));
  }
  EXPECT_NE(bytes("alone", 1), bytes("alone", 2));
}

TEST_F(PassesOfAFilm, AreKeptAndMadeAnewAsTheyNeedToBe) {
  ASSERT_EQ(passes("--out out").code, 0);
  const auto before = times("out");
  const std::string whole = bytes("out", 1);
  ASSERT_EQ(passes("--out out").code, 0);
  EXPECT_THAT(different(times("out"), before), IsEmpty());

  write_file(folder_ / "out/passes/0001.exr", whole.substr(0, whole.size() / 2));
  ASSERT_EQ(passes("--out out").code, 0);
  EXPECT_EQ(bytes("out", 1), whole) << "a damaged file is mended";

  const auto again = times("out");
  ASSERT_EQ(passes("--out out --frames 1 --passes depth").code, 0);
  EXPECT_EQ(read_layered_image(folder_ / "out/passes/0001.exr").channels.size(), 2U);
  const auto changed = different(times("out"), again);
  EXPECT_THAT(changed, testing::Contains("passes/0001.exr"));
  EXPECT_THAT(changed, Not(testing::Contains("passes/0002.exr")));
}

TEST_F(PassesOfAFilm, ArePlannedWithWhatTheyTake) {
  const auto stage_of = [&](const std::string& out) {
    const Result result =
        wold("plan small.toml --json --passes depth,species --renderer mitsuba --out " + out);
    EXPECT_EQ(result.code, 0) << result.err;
    const json plan = json::parse(result.out);
    for (const json& stage : plan.at("stages"))
      if (stage.at("stage") == "passes") return stage;
    return json();
  };
  const json planned = stage_of("out");
  EXPECT_EQ(planned.at("indices"), "1-2");
  EXPECT_EQ(planned.at("runs"), 2);
  EXPECT_EQ(planned.at("after").at("stage"), "texels");
  EXPECT_GT(planned.at("estimate").at("memory_bytes"), 1e8);
  EXPECT_GT(planned.at("estimate").at("seconds"), 0.1);
  ASSERT_EQ(passes("--passes depth,species --out out").code, 0);
  const json done = stage_of("out");
  EXPECT_EQ(done.at("runs"), 0);
  EXPECT_EQ(done.at("estimate").at("from"), "records");
  const double guessed = planned.at("estimate").at("disk_bytes");
  const double written = done.at("estimate").at("disk_bytes");
  EXPECT_GT(guessed, 0.5 * written);
  EXPECT_LT(guessed, 2.0 * written);
  const Result openjd = wold("plan small.toml --openjd --passes depth --out out");
  expect_contains(openjd.out, "\"--passes\",");
}

TEST_F(PassesOfAFilm, UnknownOnesAreRefusedWithWhatThereIs) {
  for (const std::string command : {"passes", "render", "generate", "plan"}) {
    const Result result = wold(command + " small.toml --out out --passes depth,colour");
    EXPECT_EQ(result.code, 2) << command;
    expect_contains(result.err, "--passes: found \"colour\", expected some of depth, normal");
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
  const Result task = wold("task small.toml passes 1 --out out");
  EXPECT_EQ(task.code, 2);
  expect_contains(task.err, "found stage \"passes\"");
}

TEST_F(PassesOfAFilm, AreMadeOfBladesAndNotOfPoints) {
  ASSERT_EQ(passes("--out out --frames 1 --grass blades").code, 0);
  const LayeredImage image = read_layered_image(folder_ / "out/passes/0001.exr");
  const std::vector<float>& cells = image.find("instance.X")->values;
  EXPECT_GT(std::ranges::count_if(cells, [](float column) { return column >= 0.0F; }), 100);
  const Result result = passes("--out points --grass points");
  EXPECT_EQ(result.code, 2);
  expect_contains(result.err, "--passes: found render.grass = \"points\", expected \"texels\"");
}

// Blender's compositor picks a species by its name: what it gets covers as much as inspect says.
TEST_F(PassesOfAFilm, HaveACryptomatteThatBlenderPicksFrom) {
  if (!can_render("blender")) GTEST_SKIP() << "no Blender on this machine: nothing is picked";
  ASSERT_EQ(passes("--out out --frames 1 --passes species").code, 0);
  write("pick.py", R"(import sys
import bpy
scene = bpy.context.scene
if not hasattr(scene, "node_tree"):
    print("OTHER NODES")
    sys.exit(0)
scene.use_nodes = True
nodes = scene.node_tree.nodes
nodes.clear()
pick = nodes.new("CompositorNodeCryptomatteV2")
pick.source = "IMAGE"
pick.image = bpy.data.images.load("//out/passes/0001.exr")
print(pick.layer_name)  # it looks into the file when it is asked, as its panel does
pick.matte_id = "grass"
shown = nodes.new("CompositorNodeComposite")
scene.node_tree.links.new(pick.outputs["Matte"], shown.inputs["Image"])
for thing in [thing for thing in bpy.data.objects if thing.type != "CAMERA"]:
    bpy.data.objects.remove(thing)
scene.render.engine = "CYCLES"
scene.cycles.samples = 1
scene.render.resolution_x, scene.render.resolution_y = 64, 36
scene.render.resolution_percentage = 100
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.filepath = sys.argv[-1]
bpy.ops.render.render(write_still=True)
)");
  const Result picked = shell(
      "sed -i \"s#//out#$PWD/out#\" pick.py && blender -b --factory-startup --python-exit-code 1 "
      "-P pick.py -- \"$PWD/matte.exr\"");
  ASSERT_EQ(picked.code, 0) << picked.out << picked.err;
  if (picked.out.find("OTHER NODES") != std::string::npos)
    GTEST_SKIP() << "a Blender whose compositor has other nodes: nothing is picked";
  const Image matte = read_image(folder_ / "matte.exr");
  double sum = 0.0;
  for (int y = 0; y < matte.height; ++y)
    for (int x = 0; x < matte.width; ++x) sum += double{*matte.pixel(x, y)};
  const json facts = json::parse(wold("inspect out/passes/0001.exr --json").out);
  const double grass = facts.at(0).at("layers").at("species").at("covered_by").at("grass");
  EXPECT_GT(grass, 0.03);
  EXPECT_NEAR(sum / (matte.width * matte.height), grass, 1e-4);
}

TEST_F(PassesOfAFilm, AreExplainedByInspect) {
  ASSERT_EQ(passes("--out out --frames 1").code, 0);
  const Result result = wold("inspect out/passes/0001.exr --json");
  EXPECT_EQ(result.code, 0) << result.out;
  const json facts = json::parse(result.out).at(0);
  const json& depth = facts.at("layers").at("depth");
  EXPECT_EQ(depth.at("unit"), "m");
  EXPECT_THAT(depth.at("meaning").get<std::string>(), HasSubstr("planar"));
  const json& range = depth.at("channels").at("depth.Z").at("range");
  EXPECT_GT(range.at(0), 0.5);
  EXPECT_LT(range.at(1), 10.0);
  const json& names = facts.at("layers").at("species").at("covered_by");
  double sum = 0.0;
  for (const auto& [name, fraction] : names.items()) sum += fraction.get<double>();
  EXPECT_NEAR(sum, depth.at("channels").at("depth.A").at("mean").get<double>(), 1e-3);
}

}  // namespace
}  // namespace wold::test
