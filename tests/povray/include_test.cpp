// What the include files, shipped and written, leave in a scene that reads them: only names that
// begin with Wold_, and the scene's own #version.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "core/file_list.h"
#include "povray/own_scene.h"
#include "support/cloudy_view.h"
#include "support/quartered.h"
#include "support/snowy_view.h"
#include "support/synthetic_landscape.h"

namespace wold::povray {
namespace {
namespace fs = std::filesystem;

/// Cells, parts of cells, blades, clouds, a backdrop, finer ground, flakes and fog.
landscape::Landscape all_there_is(const fs::path& folder) {
  landscape::Landscape scene = test::synthetic_landscape(
      {.cells_per_side = 2, .height_voxels = 8, .width_px = 16, .height_px = 9}, folder);
  landscape::Landscape cloudy = scene;
  test::make_cloudy_view(cloudy);
  scene.clouds = cloudy.clouds;
  scene.backdrop = cloudy.backdrop;
  test::quarter_cells(scene);
  test::add_flakes(scene, 40, 5.0);
  scene.fog = landscape::Fog{0.01, glm::vec3(0.1F)};
  scene.ground_details = {{ColourMap(3, 0.5), {0.2, 0.3}}};
  return scene;
}

/// A file's text without its comments and what its strings say.
std::string code_of(const fs::path& file) {
  static const std::regex silent(R"re("[^"]*"|//[^\n]*)re");
  return std::regex_replace(read_file(file), silent, "\"\"");
}

std::vector<std::string> all_matches(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> names;
  for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
    names.push_back((*at)[1]);
  return names;
}

std::vector<fs::path> include_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::path& file : files_below(folder))
    if (file.extension() == ".inc") files.push_back(file);
  return files;
}

class Includes : public OwnScene {
 protected:
  void SetUp() override {
    OwnScene::SetUp();
    export_all(scene);
  }

  const landscape::Landscape scene = all_there_is(folder.path() / "texels");
  const std::vector<const char*> all_macros = {"Wold_Terrain(0)",
                                               "Wold_Shadows(sphere { 0, 1 })",
                                               "Wold_Light(0)",
                                               "Wold_Lamp(z, rgb 1, 1)",
                                               "Wold_Ground(0)",
                                               "Wold_Clouds(0)",
                                               "Wold_Grass(Wold_terrain, 0)",
                                               "Wold_Snow(0)",
                                               "Wold_Camera(0)"};
};

/// That the version is still that of the scene.
std::string check_version(const std::string& version, const std::string& after) {
  return fmt::format("\n#if (version != {}) #error \"version after {}\" #end\n", version, after);
}

TEST_F(Includes, DeclareNamesOfTheirOwnAndNothingForTheWholeScene) {
  for (const fs::path& file : include_files(folder.path() / "povray")) {
    SCOPED_TRACE(file);
    const std::string code = code_of(file);
    EXPECT_THAT(all_matches(code, R"(#\s*(?:declare|undef|macro|fopen)\s+(\w+))"),
                testing::Each(testing::StartsWith("Wold_")));
    EXPECT_THAT(all_matches(code, R"(#\s*local\s+(\w+))"), testing::Each(testing::StartsWith("_")));
    for (const std::string& parameters : all_matches(code, R"(#\s*macro\s+\w+\s*\(([^)]*)\))"))
      EXPECT_THAT(all_matches(parameters, R"((\w+))"), testing::Each(testing::StartsWith("_")));
    EXPECT_THAT(all_matches(code, R"((global_settings|#\s*default|#\s*for\b))"),
                testing::IsEmpty());
  }
}

// Each file by itself: what the shipped ones read is there already, or they would hide each other.
TEST_F(Includes, GiveTheVersionBackEachTime) {
  const fs::path povray = folder.path() / "povray";
  std::string shipped, written;
  for (const fs::path& file : include_files(povray)) {
    const std::string name = file.lexically_relative(povray).string();
    if (name == "wold.inc") continue;
    std::string& text = name.starts_with("wold_") ? shipped : written;
    text += fmt::format("#include \"{}\"", name) + check_version("3.6", name);
  }
  ASSERT_GE(std::ranges::count(shipped, '\n'), 2 * 6);
  ASSERT_GE(std::ranges::count(written, '\n'), 2 * 9);
  std::string text = "#version 3.6;\n" + shipped + "#include \"wold.inc\"" +
                     check_version("3.6", "wold.inc") + "global_settings { Wold_Settings(0) }";
  for (const char* macro : all_macros)
    text += macro + check_version("3.6", std::string(macro).substr(0, 11));
  run_whole(scene, text + written);
}

// What a scene has changed after the first time stays.
TEST_F(Includes, AreReadOnce) {
  const std::vector<const char*> numbers = {"Wold_units_per_m", "Wold_shadow_samples",
                                            "Wold_min_samples", "Wold_cloud_intervals",
                                            "Wold_least_lamplight"};
  const auto files = {"wold.inc", "wold_shadows.inc", "wold_things.inc", "wold_grass.inc",
                      "wold_clouds.inc"};
  std::string text = "#version 3.7;\n#include \"wold.inc\"\n";
  for (const char* number : numbers) text += fmt::format("#declare {} = 77;\n", number);
  for (const char* file : files) text += fmt::format("#include \"{}\"\n", file);
  for (const char* number : numbers)
    text += fmt::format("#if ({0} != 77) #error \"{0}\" #end\n", number);
  run_whole(scene, text + "camera { location 0 }");
}

/// How a scene declares a name and asks whether it is still what it was.
struct Declaration {
  const char* kind;
  const char* text;
  const char* value;
};

class OwnNames : public Includes, public testing::WithParamInterface<Declaration> {};

// Common names, and such as the files once had.
TEST_P(OwnNames, AreLeftAlone) {
  const auto names = {"I",      "J",           "N",       "V",      "P",     "Frame",  "Frames",
                      "Grass",  "Sky",         "Cells",   "Cell",   "Part",  "Ground", "Fog",
                      "Light",  "Lights",      "Volume",  "Grid",   "Here",  "Mesh",   "Side",
                      "Middle", "Count",       "Step",    "Corner", "Map",   "Hit",    "Normal",
                      "Stem",   "Units_per_m", "Terrain", "Things", "Cloud", "Clouds", "Flakes",
                      "Snow",   "Camera",      "Degree",  "Voxels"};
  std::string declared, checked;
  for (const char* name : names) {
    declared += fmt::format(fmt::runtime(GetParam().text), name) + "\n";
    checked += fmt::format("#if ({} != 7) #error \"{} is not what it was\" #end\n",
                           fmt::format(fmt::runtime(GetParam().value), name), name);
  }
  std::string used = "global_settings { Wold_Settings(0) }\n";
  for (const char* macro : all_macros) used += std::string(macro) + "\n";
  run_whole(scene, "#version 3.7;\n" + declared + "#include \"wold.inc\"\n#include \"wold.inc\"\n" +
                       checked + used + checked + check_version("3.7", "all"));
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, OwnNames,
    testing::Values(Declaration{"numbers", "#declare {} = 7;", "{}"},
                    Declaration{"macros", "#macro {}() 7 #end", "{}()"},
                    Declaration{"functions", "#declare {} = function(x) {{ x + 7 }}", "{}(0)"}),
    [](const auto& test) { return std::string(test.param.kind); });

// A scene of an older version gets the same picture of the landscape.
TEST_F(Includes, ShowTheSameInAnOlderVersion) {
  const auto picture = [&](const char* version) {
    std::string text = fmt::format("#version {};\n#include \"wold.inc\"\n", version);
    text += "global_settings { Wold_Settings(0) }\n";
    for (const char* macro : all_macros) text += std::string(macro) + "\n";
    return run_whole(scene, text).values;
  };
  EXPECT_EQ(picture("3.6"), picture("3.7"));
}

}  // namespace
}  // namespace wold::povray
