#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/image.h"
#include "film/exporters.h"
#include "small_film.h"
#include "work/complete_job.h"
#include "work/disk_budget.h"

/// From the scene file to the folders of the renderers and back again: what is made twice is the
/// same, and what is there already is kept.
namespace wold::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class Generate : public SmallFilm {
 protected:
  void generate(const std::string& folder, const std::string& options = "") const {
    const Result result = wold("generate small.toml --quiet --out " + folder + " " + options);
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out + result.err, "");
  }
};

/// The files written since `before` whose paths have a part in them.
std::vector<std::string> rewritten(const std::map<std::string, fs::file_time_type>& before,
                                   const std::map<std::string, fs::file_time_type>& after,
                                   const std::string& part) {
  std::vector<std::string> paths = different(after, before);
  std::erase_if(paths, [&](const std::string& path) {
    return path.find(part) == std::string::npos || after.count(path) == 0;
  });
  return paths;
}

TEST_F(Generate, SameSceneSameBytesWithAnyNumberOfThreads) {
  generate("one", "--threads 1");
  const auto wanted = contents("one");
  for (const std::string file :
       {"scene.toml", "texels/v0_k00_030.vdb", "blender/data/frame_0002/frame.json",
        "povray/scene.pov", "povray/data/frame_0002/frame.inc"})
    EXPECT_EQ(wanted.count(file), 1U) << file;
  for (const auto& [file, hash] : wanted)
    EXPECT_FALSE(file.ends_with(".py")) << file << ": exported folders hold data only";
  generate("again", "--threads 1");
  EXPECT_THAT(different(contents("again"), wanted), IsEmpty());
  generate("two", "--threads 2");
  EXPECT_THAT(different(contents("two"), wanted), IsEmpty());
  expect_nothing_half_written("one");
}

// A large terrain's snow lies in scratch files while frames are made.
TEST_F(Generate, TheManifestListsWhatIsThereAndNothingElse) {
  generate("out",
           "--frames 1 --set terrain.size=1300 --set grass.levels=[30] --set grass.variants=1 "
           "--set weather.temperature=-3 --set weather.precipitation=2");
  std::set<std::string> listed, there;
  const auto manifest = nlohmann::json::parse(read_file(folder_ / "out/manifest.json"));
  for (const nlohmann::json& file : manifest.at("files")) listed.insert(file.at("path"));
  for (const fs::path& file : files_below(folder_ / "out"))
    if (file != "manifest.json" && *file.begin() != "tasks") there.insert(file.string());
  EXPECT_EQ(listed, there);
}

TEST_F(Generate, TheIndexOfFramesListsAllOfThemWhicheverAreMade) {
  const std::string frames = "--set 'ageing.frames=[0.1, 0.8, 0.5]' --set film.frame_seconds=60 ";
  generate("all", frames);
  generate("last", frames + "--frames 3");
  const std::string index = read_file(folder_ / "last/povray/data/frames.inc");
  EXPECT_EQ(index, read_file(folder_ / "all/povray/data/frames.inc"));
  for (const char* row : {"{ 1, 0.1, 0 }", "{ 2, 0.8, 60 }", "{ 3, 0.5, 120 }"})
    EXPECT_THAT(index, HasSubstr(row));
}

// Two thirds of a texel's bytes are what only a renderer that lights grass itself reads.
TEST_F(Generate, TexelsWithoutLightAreThereForWhoReadsThem) {
  const fs::path unlit = folder_ / "out/texels/v0_k00.vdb";
  generate("out", "--renderer blender");
  EXPECT_FALSE(fs::exists(unlit));
  const auto baked = contents("out/texels");
  generate("out", "--renderer mitsuba");
  EXPECT_TRUE(fs::exists(unlit)) << "another exporter has other needs";
  auto all = contents("out/texels");
  std::erase_if(all, [&](const auto& file) { return baked.count(file.first) == 0; });
  EXPECT_THAT(different(all, baked), IsEmpty());
}

// Farms write each frame by itself.
TEST_F(Generate, AFrameOfUsdIsTheSameAloneAndNoPictureIsMade) {
  const std::string options = "small.toml --quiet --renderer usd --grass blades --out ";
  EXPECT_EQ(wold("render " + options + "all").code, 0);
  EXPECT_EQ(wold("render " + options + "last --frames 2").code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "all/frames"));
  const auto all = contents("all/usd"), last = contents("last/usd");
  EXPECT_TRUE(all.contains("frame.0001.usda"));
  EXPECT_FALSE(last.contains("frame.0001.usda"));
  for (const auto& [file, hash] : last)
    EXPECT_TRUE(all.contains(file) && all.at(file) == hash) << file;
}

TEST_F(Generate, KeepsTexelsAndVolumesThatAreStillRight) {
  generate("out");
  const auto before = times("out");
  generate("out", "--set render.exposure=1 --set 'ageing.frames=[0.1, 0.8, 0.8]'");
  EXPECT_THAT(rewritten(before, times("out"), "texels/"), IsEmpty());
  EXPECT_THAT(rewritten(before, times("out"), "/volumes/"), IsEmpty());
  EXPECT_TRUE(fs::exists(folder_ / "out/povray/data/frame_0003/frame.inc"));
}

TEST_F(Generate, ReplacesAMissingOrDamagedTexelAlone) {
  generate("out");
  const auto wanted = contents("out");
  const auto before = times("out");
  fs::remove(folder_ / "out/texels/v0_k00_030.vdb");
  fs::resize_file(folder_ / "out/texels/v1_k01_030.vdb", 1000);
  generate("out");
  EXPECT_THAT(different(contents("out"), wanted), IsEmpty());
  for (const std::string& path : rewritten(before, times("out"), "texels/"))
    EXPECT_THAT(path, testing::AnyOf(testing::StartsWith("texels/v0_k00"),
                                     testing::StartsWith("texels/v1_k01")));
}

TEST_F(Generate, AChangedSceneLeavesNothingOfTheOldOne) {
  generate("out");
  generate("out", "--set grass.height=0.2");
  generate("new", "--set grass.height=0.2");
  const auto wanted = contents("new");
  auto got = contents("out");
  std::erase_if(got, [&](const auto& file) { return wanted.count(file.first) == 0; });
  EXPECT_THAT(different(got, wanted), IsEmpty());
}

class Resume : public SmallFilm {
 protected:
  /// Renders with a script in Blender's place; the frames it was called for.
  std::string rendered(const std::string& options = "") const {
    const std::string blender = blender_played_by("cp $good \"$out\"");
    const Result result =
        wold("render small.toml --quiet --renderer blender --out out " + options, blender);
    EXPECT_EQ(result.code, 0) << result.err;
    return calls();
  }
};

TEST_F(Resume, RendersWhatIsMissingAndNothingElse) {
  const fs::path frames = folder_ / "out/frames/blender";
  EXPECT_EQ(rendered("--frames 2"), "2 ");
  EXPECT_EQ(rendered(), "1 ");
  EXPECT_EQ(rendered(), "");
  const auto kept = fs::last_write_time(frames / "0001.png");
  fs::remove(frames / "0002.png");
  EXPECT_EQ(rendered(), "2 ");
  EXPECT_EQ(fs::last_write_time(frames / "0001.png"), kept);
}

TEST_F(Resume, RendersAnewWhatAnotherSceneMade) {
  EXPECT_EQ(rendered(), "1 2 ");
  EXPECT_EQ(rendered("--threads 1 --set render.timeout=5"), "") << "these change no pixel";
  EXPECT_EQ(rendered("--set render.exposure=1"), "1 2 ");
  EXPECT_EQ(rendered("--set render.exposure=1 --set 'camera.eye=[3, 0.4]'"), "1 2 ");
}

// What a picture is made from is in its scene files: frames that stay as they were are kept.
TEST_F(Resume, RendersTheFramesThatAChangeTouches) {
  EXPECT_EQ(rendered(), "1 2 ");
  EXPECT_EQ(rendered("--set 'ageing.frames=[0.1, 0.8, 0.9]'"), "3 ");
  EXPECT_EQ(rendered("--set 'ageing.frames=[0.1, 0.7, 0.9]'"), "2 ");
}

TEST_F(Resume, ANewCameraNeedsNoNewTexels) {
  rendered();
  const auto before = times("out");
  EXPECT_EQ(rendered("--set camera.field_of_view=50"), "1 2 ");
  EXPECT_THAT(rewritten(before, times("out"), "texels/v"), IsEmpty());
}

TEST_F(Resume, SeesThatAFileWhichTheSceneNamesHasChanged) {
  Image mask(2, 2, 1);
  std::ranges::fill(mask.values, 1.0F);
  write_image(folder_ / "mask.png", mask, PixelFormat::uint8);
  const std::string masked = "--set growth.mask=\\\"mask.png\\\"";
  EXPECT_EQ(rendered(masked), "1 2 ");
  EXPECT_EQ(rendered(masked), "");
  mask.values.front() = 0.0F;
  write_image(folder_ / "mask.png", mask, PixelFormat::uint8);
  EXPECT_EQ(rendered(masked), "1 2 ");
}

TEST_F(Resume, MakesDamagedFilesAnew) {
  rendered();
  const auto wanted = contents("out");
  const std::string picture = "out/frames/blender/0001.png";
  write(picture, std::string(read_file(folder_ / picture).size(), 'x'));
  EXPECT_EQ(rendered(), "1 ");
  for (const std::string name : {"blender/data/volumes", "blender/data/frame_0002", "texels"}) {
    const fs::path file = files_below(folder_ / "out" / name).front();
    std::string bytes = read_file(folder_ / "out" / name / file);
    bytes.back() = static_cast<char>(~bytes.back());
    write("out/" + name + "/" + file.string(), bytes);
  }
  EXPECT_EQ(rendered(), "") << "the same scene files come back";
  EXPECT_THAT(different(contents("out"), wanted), IsEmpty());
}

TEST_F(Resume, WithoutKeptTexelsNothingIsMadeAgain) {
  rendered();
  auto wanted = contents("out");
  EXPECT_EQ(rendered("--keep scenes"), "");
  EXPECT_TRUE(files_below(folder_ / "out/texels").empty());
  std::erase_if(wanted, [](const auto& file) { return file.first.starts_with("texels/"); });
  EXPECT_THAT(different(contents("out"), wanted), IsEmpty());
  const auto before = times("out");
  for (const std::string options : {"", "--keep scenes", "--frames 2"}) {
    EXPECT_EQ(rendered(options), "") << options;
    EXPECT_TRUE(files_below(folder_ / "out/texels").empty()) << options;
  }
  EXPECT_THAT(rewritten(before, times("out"), "blender/"), IsEmpty());
  const std::string plan = wold("plan small.toml --renderer blender --out out").out;
  EXPECT_THAT(plan, HasSubstr("texels  0 of 2 to do;"));
}

TEST_F(Resume, TexelsThatWereNotKeptComeBackWhenSceneFilesNeedThem) {
  rendered();
  const auto wanted = contents("out");
  rendered("--keep scenes");
  fs::remove(folder_ / "out/blender/data/frame_0002/frame.json");
  EXPECT_THAT(wold("plan small.toml --renderer blender --why --out out").out,
              HasSubstr("removed when nothing needed it"));
  EXPECT_EQ(rendered(), "") << "the same scene files come back";
  EXPECT_THAT(different(contents("out"), wanted), IsEmpty());
}

// A process that is killed has said in its records that texels go, and has removed some.
TEST_F(Resume, TexelsThatAKilledProcessWasRemovingAreRemoved) {
  rendered();
  const auto wanted = contents("out");
  rendered("--keep scenes");
  fs::create_directory(folder_ / "out/texels");
  for (const auto& [name, hash] : wanted)
    if (name.starts_with("texels/v0")) write("out/" + name, "half of them are left");
  EXPECT_EQ(rendered(), "");
  EXPECT_EQ(rendered("--keep scenes"), "");
  EXPECT_TRUE(files_below(folder_ / "out/texels").empty());
}

TEST_F(Resume, PicturesAloneAreThoseOfScenesThatStay) {
  const auto source_of = [&](int frame) {
    const auto record = nlohmann::json::parse(
        read_file(folder_ / fmt::format("out/tasks/blender_{:04}.json", frame)));
    return record.at("source").get<std::string>();
  };
  EXPECT_EQ(rendered("--passes depth"), "1 2 ");
  auto wanted = contents("out");
  const std::string source = source_of(2);
  fs::remove_all(folder_ / "out");
  EXPECT_EQ(rendered("--passes depth --keep pictures"), "1 2 ");
  EXPECT_EQ(source_of(2), source) << "shows the same scene files";
  EXPECT_FALSE(fs::exists(folder_ / "out/texels"));
  EXPECT_FALSE(fs::exists(folder_ / "out/blender/data"));
  std::erase_if(wanted, [](const auto& file) {
    return file.first.starts_with("texels/") || file.first.starts_with("blender/data/");
  });
  EXPECT_THAT(different(contents("out"), wanted), IsEmpty());
  const auto before = times("out/frames");
  for (const std::string options : {"", "--keep pictures", "--keep scenes", "--frames 2"})
    EXPECT_EQ(rendered(options), "") << options;
  EXPECT_THAT(different(times("out/frames"), before), IsEmpty());
  EXPECT_FALSE(fs::exists(folder_ / "out/texels"));
  const std::string plan = wold("plan small.toml --renderer blender --out out").out;
  for (const std::string stage : {"texels ", "scenes ", "blender"})
    EXPECT_THAT(plan, HasSubstr("  " + stage + " 0 of 2 to do;"));
}

/// Blender's, whose scene files are said to be so large that four frames take more than a gigabyte.
const exporter::Exporter& heavy_exporter() {
  static const exporter::Exporter heavy = [] {
    exporter::Exporter blender = *exporter::find_exporter(film::exporters(), "blender");
    blender.files.frame = 300e6;
    return blender;
  }();
  return heavy;
}

TEST_F(Resume, SceneFilesThatWereShownGoWhileOthersAreMade) {
  blender_played_by(fmt::format("cp $good \"$out\"; ls '{}' | grep -c frame_ >>'{}'",
                                (folder_ / "out/blender/data").string(),
                                (folder_ / "there").string()));
  work::RenderOptions options;
  options.scene = folder_ / "small.toml";
  options.out = folder_ / "out";
  options.overrides = {"ageing.frames=[1, 0, 1, 0, 1, 0, 1, 0, 1]", "render.renderer=\"blender\""};
  options.programs = {{"blender", (folder_ / "fake.sh").string()}};
  options.keep = work::Keep::pictures;
  work::Job job = work::plan_job(options);
  job.exporters = {&heavy_exporter()};
  SilentProgress progress;
  work::complete_job(job, work::stages_of(job), progress);
  EXPECT_EQ(calls(), "1 2 3 4 5 6 7 8 9 ");
  EXPECT_EQ(read_file(folder_ / "there"), "3\n3\n3\n3\n3\n3\n3\n3\n3\n");
  EXPECT_FALSE(fs::exists(folder_ / "out/blender/data"));
  EXPECT_FALSE(fs::exists(folder_ / "out/texels"));
  const auto wanted_bytes = [&] {
    work::Work work(job);
    return work::missing_bytes(job, work::stages_of(job), work);
  };
  EXPECT_EQ(wanted_bytes(), 0.0);
  job.has_pictures = false;
  EXPECT_GT(wanted_bytes(), 0.0) << "of disk, for scene files that come back";
}

TEST_F(Resume, APictureThatIsMissedComesBackWithoutItsSceneFiles) {
  rendered("--keep pictures");
  const auto wanted = contents("out");
  fs::remove(folder_ / "out/frames/blender/0002.png");
  EXPECT_THAT(wold("plan small.toml --renderer blender --why --out out").out,
              HasSubstr("scenes  1 of 2 to do;"));
  EXPECT_EQ(rendered("--keep pictures"), "2 ");
  EXPECT_THAT(different(contents("out"), wanted), IsEmpty());
  EXPECT_EQ(rendered("--keep pictures --set render.exposure=1"), "1 2 ");
}

TEST_F(Resume, SceneFilesThatOthersShareStay) {
  rendered("--frames 1 --set 'ageing.frames=[0.1, 0.1]'");
  const auto wanted = contents("out/blender");
  EXPECT_EQ(rendered("--frames 2 --keep pictures --set 'ageing.frames=[0.1, 0.1]'"), "2 ");
  EXPECT_THAT(different(contents("out/blender"), wanted), IsEmpty());
}

// A process that is killed has said in its records that scene files go, and has removed some.
TEST_F(Resume, SceneFilesThatAKilledProcessWasRemovingAreRemoved) {
  rendered();
  const auto all = contents("out/blender/data");
  rendered("--keep pictures");
  for (const auto& [name, hash] : all) {
    if (name < "frame_0002") continue;  // in their order
    fs::create_directories((folder_ / "out/blender/data" / name).parent_path());
    write("out/blender/data/" + name, "half of them are left");
  }
  EXPECT_EQ(rendered(), "");
  EXPECT_EQ(rendered("--keep pictures"), "");
  EXPECT_FALSE(fs::exists(folder_ / "out/blender/data"));
}

// Its record says that it has files which it does not make.
TEST_F(Resume, ARecordOfSceneFilesCannotHaveOthersRemoved) {
  rendered();
  const fs::path path = folder_ / "out/tasks/scenes_0001.json";
  auto record = nlohmann::json::parse(read_file(path));
  write("out/blender/mine.blend", "a user's");
  for (const char* name : {"blender/mine.blend", "frames/blender/0002.png"})
    record["outputs"][name] = {8, 0, content_hash("a user's")};
  write_file(path, record.dump());
  write("out/frames/blender/0002.png", "a user's");
  rendered("--frames 1 --keep pictures");
  EXPECT_FALSE(fs::exists(folder_ / "out/blender/data/frame_0001"));
  EXPECT_TRUE(fs::exists(folder_ / "out/blender/mine.blend"));
  EXPECT_TRUE(fs::exists(folder_ / "out/frames/blender/0002.png"));
}

TEST_F(Resume, SceneFilesThatAreAskedForComeBack) {
  rendered();
  const auto wanted = contents("out");
  rendered("--keep pictures");
  const std::string generate = "generate small.toml --quiet --renderer blender --out out";
  EXPECT_THAT(wold(generate + " --dry-run").out, HasSubstr("scenes  2 of 2 to do;"));
  EXPECT_EQ(wold(generate).code, 0);
  EXPECT_THAT(different(contents("out"), wanted), IsEmpty());
  EXPECT_EQ(rendered(), "") << "pictures of the same scene files stay";
}

TEST_F(Resume, PassesThatAreDoneNeedNoTexels) {
  const std::string passes = "passes small.toml --quiet --passes depth --out out --keep scenes";
  EXPECT_EQ(wold(passes).code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "out/texels"));
  const auto before = times("out/passes");
  EXPECT_EQ(wold(passes).code, 0);
  EXPECT_THAT(different(times("out/passes"), before), IsEmpty());
  EXPECT_THAT(wold("passes small.toml --passes depth --out out --dry-run").out,
              HasSubstr("texels  0 of 2 to do;"));
}

TEST_F(Resume, PicturesAloneStayOfWhatHasSome) {
  const Result result =
      wold("render small.toml --renderer blender,usd --grass blades --keep pictures --out out");
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.err, HasSubstr("--keep: found pictures, expected scenes or all with "
                                    "render.renderer \"usd\""));
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Resume, PrintsThePicturesItStandsFor) {
  const std::string render = "render small.toml --quiet --renderer blender --out out";
  const std::string blender = blender_played_by("cp $good \"$out\"");
  const std::string pictures = "out/frames/blender/0001.png\nout/frames/blender/0002.png\n";
  EXPECT_EQ(wold(render, blender).out, pictures);
  EXPECT_EQ(wold(render, blender).out, pictures);
}

}  // namespace
}  // namespace wold::test
