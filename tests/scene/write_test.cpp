#include "scene/write.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/parse.h"
#include "scene/registry.h"
#include "scene/renderers.h"

namespace wold::scene {
namespace {

void expect_fixed_point(const Scene& scene) {
  const std::string text = resolved_toml(scene);
  const Scene again = parse_scene(text, "resolved");
  EXPECT_EQ(again, scene);
  EXPECT_EQ(resolved_toml(again), text);
}

TEST(ResolvedToml, IsAFixedPointOfParsing) {
  expect_fixed_point(Scene{});
  Scene scene;
  scene.name = "A.b-c_9";
  scene.seed = 9007199254740991;
  scene.terrain.size_m = 123.0;
  scene.terrain.relief_m = 1.0 / 3.0;
  scene.terrain.relief_feature_m = 0.1 + 0.2;
  scene.grass.lods = {30};
  scene.grass.mingle = {{"late", {}}, {"", {{0.0, 0.1}, {0.4, 0.1}, {1.0, 0.75}}}, {"early", {}}};
  scene.grass.key_frames = {0.0, 1e-300, 1.0};
  scene.ageing.water = {"", {{0.0, 1.0}, {0.1, 0.7}, {1.0, 1e-7}}};
  scene.ageing.frames = {1.0, 0.0};
  scene.render.exposure = -0.25;
  scene.clouds.resize(2);
  scene.clouds[0].kind = CloudKind::cirrus;
  scene.clouds[0].cover = 0.1 + 0.2;
  scene.clouds[1].cells = {3, 5};
  scene.cloud_events.resize(2);
  scene.cloud_events[1] = {
      .kind = CloudEventKind::light, .layer = 2, .start_s = 61.0, .colour = {}};
  scene.season.first = {2026, 9, 1};
  scene.season.last = {2026, 12, 1};
  scene.season_keys = {{.date = {2026, 9, 1}, .weathering = 0.1 + 0.2}};
  expect_fixed_point(scene);
}

TEST(ResolvedToml, SaysRenderersInAWordWhereThereIsOne) {
  const auto line = [](const std::string& value) {
    const std::string text =
        resolved_toml(parse_scene("[render]\nrenderer = " + value + "\n", "a.toml"));
    const std::size_t start = text.find("\nrenderer = ") + 1;
    return text.substr(start, text.find('\n', start) - start);
  };
  EXPECT_EQ(line("['blender', 'povray']"), "renderer = \"both\"");
  EXPECT_EQ(line("['povray']"), "renderer = \"povray\"");
  EXPECT_EQ(line("'blender'"), "renderer = \"blender\"");
  EXPECT_EQ(toml_text(renderers_value({"blender", "another"})), "[\"blender\", \"another\"]");
}

// What files are told apart by: every value counts, no word for people does.
TEST(SettingsText, HasEveryKeyAndNoMeaning) {
  Scene scene;
  scene.species.resize(2);
  const std::string text = settings_text(scene);
  for (const Key& key : registry()) {
    EXPECT_NE(("\n" + text).find("\n" + key.name + " = "), std::string::npos) << key.name;
    EXPECT_EQ(text.find(key.doc), std::string::npos) << key.name;
  }
  scene.species[1].plant.height_m = 0.7;
  const std::string other = settings_text(scene);
  EXPECT_NE(other, text);
  EXPECT_NE(other.find("\nspecies[2].height = 0.7\n"), std::string::npos);
}

TEST(ResolvedToml, HasEveryKeyWithItsMeaning) {
  Scene scene;
  scene.species.resize(1);
  scene.clouds.resize(1);
  scene.cloud_events.resize(1);
  scene.season_keys.resize(1);
  scene.shots.resize(1);
  scene.paths.resize(1);
  scene.cover_classes.resize(1);
  const std::string text = resolved_toml(scene);
  std::vector<Key> keys = registry();
  for (const TableArray& array : table_arrays())
    for (const Key& key : array.keys(0)) keys.push_back(key);
  for (const Key& key : keys) {
    EXPECT_NE(text.find(fmt::format("\n{} = ", leaf_of(key.name))), std::string::npos);
    EXPECT_NE(text.find(key.doc), std::string::npos) << key.name;
  }
  EXPECT_NE(text.find("# Side of the patch that repeats. Accepts a number from 0.05 to 20 m.\n"
                      "patch = 0.6\n"),
            std::string::npos);
}

}  // namespace
}  // namespace wold::scene
