#include "film/exporters.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "core/files.h"
#include "film/film.h"
#include "scene/renderers.h"
#include "support/file_only_exporter.h"
#include "support/temporary_folder.h"

namespace wold::film {
namespace {

namespace fs = std::filesystem;

scene::Scene tiny_film() {
  scene::Scene scene;
  scene.terrain.size_m = 6.0;
  scene.terrain.samples = 33;
  scene.terrain.hill_height_m = 0.5;
  scene.grass.lods = {16};
  scene.grass.variants = 1;
  scene.camera.eye_m = {3.0, 0.5};
  scene.camera.target_m = {3.0, 4.0};
  scene.render.size_px = {48, 27};
  scene.ageing.frames = {0.0, 0.5};
  return scene;
}

TEST(Exporters, HaveNamesOfTheirOwnThatScenesAccept) {
  std::set<std::string_view> names;
  std::vector<std::string> words;
  for (const exporter::Exporter* one : exporters()) {
    EXPECT_TRUE(names.insert(one->name).second) << one->name;
    EXPECT_FALSE(one->display_name.empty()) << one->name;
    words.emplace_back(one->name);
  }
  words.emplace_back("both");
  EXPECT_EQ(words, scene::renderer_words());
}

TEST(Exporters, AreThoseThatTheSceneAsksFor) {
  scene::Scene scene;
  EXPECT_EQ(wanted_exporters(scene).size(), 2U);
  scene.render.renderers = {"povray"};
  ASSERT_EQ(wanted_exporters(scene).size(), 1U);
  EXPECT_EQ(wanted_exporters(scene).front()->name, "povray");
}

TEST(FilmSettings, CountFramesFromOne) {
  const exporter::FilmSettings film = film_settings(tiny_film());
  ASSERT_EQ(film.frames.size(), 2U);
  EXPECT_EQ(film.frames[0].frame, 1);
  EXPECT_EQ(film.frames[1].frame, 2);
  EXPECT_EQ(film.frames[1].weathering, 0.5);
}

TEST(Exporters, AskTogetherForTheStrictestOfAll) {
  const std::array wanted = {exporters().front(), &test::file_only_exporter()};
  EXPECT_EQ(exporter::needs_of_all(wanted).max_flakes_on_a_ray, 50.0);
  EXPECT_TRUE(exporter::needs_of_all(wanted).materials);
  EXPECT_TRUE(needs_of(wanted).materials);
  EXPECT_FALSE(needs_of({}).materials);
}

// Otherwise a scene's picture of one renderer would depend on whether another makes one, too.
TEST(Exporters, LimitPicturesAlikeWhicheverAreWanted) {
  const double all = needs_of(exporters()).max_flakes_on_a_ray;
  EXPECT_LT(all, 240.0);
  for (const exporter::Exporter* one : exporters())
    EXPECT_EQ(needs_of(std::array{one}).max_flakes_on_a_ray, all) << one->name;
}

TEST(Exporters, OneWithoutARendererGetsItsFiles) {
  const test::TemporaryFolder folder("file_only");
  SilentProgress progress;
  const Request request = {tiny_film(), {2}, folder.path(), {&test::file_only_exporter()}};
  const std::vector<fs::path> files = make_film(request, progress);
  EXPECT_EQ(files, (std::vector{folder.path() / "film.txt", folder.path() / "lines/0002.txt"}));
  EXPECT_EQ(read_file(folder.path() / "film.txt"), "2 frames\n");
  EXPECT_TRUE(read_file(folder.path() / "lines/0002.txt").starts_with("2 of 2, "));
  EXPECT_FALSE(fs::exists(folder.path() / "povray"));
}

// What one exporter writes does not depend on who else writes.
TEST(Exporters, OneMoreChangesNoFileOfTheOthers) {
  const test::TemporaryFolder folder("one_more");
  SilentProgress progress;
  const exporter::Exporter* povray = exporter::find_exporter(exporters(), "povray");
  ASSERT_NE(povray, nullptr);
  const fs::path alone = folder.path() / "alone", together = folder.path() / "together";
  const auto files = make_film({tiny_film(), {1}, alone, {povray}}, progress);
  make_film({tiny_film(), {1}, together, {povray, &test::file_only_exporter()}}, progress);
  EXPECT_GT(files.size(), 3U);
  for (const fs::path& file : files) {
    const fs::path other = together / file.lexically_relative(alone);
    ASSERT_TRUE(fs::exists(other)) << other;
    EXPECT_EQ(read_file(file), read_file(other)) << other;
  }
}

}  // namespace
}  // namespace wold::film
