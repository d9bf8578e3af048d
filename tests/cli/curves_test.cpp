#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <vector>

#include "core/files.h"
#include "program.h"

namespace wold::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class Curves : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    write("a.toml", "name = \"heath\"\n");
  }

  std::string made(const std::string& file, const std::string& options = "") const {
    const Result result = wold("curves a.toml --out " + file + options);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "");
    return read_file(folder_ / file);
  }

  /// The files of the test's folder but for the program's output.
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (name != ".out" && name != ".err") names.push_back(name);
    }
    return names;
  }

  void expect_failure(const std::string& arguments, int code, const std::string& part) const {
    const std::vector<std::string> before = files();
    const Result result = wold("curves " + arguments);
    EXPECT_EQ(result.code, code);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, testing::StartsWith("error: "));
    EXPECT_THAT(result.err, HasSubstr(part));
    EXPECT_THAT(files(), testing::UnorderedElementsAreArray(before));
  }
};

/// The columns of a table by name.
std::map<std::string, std::vector<double>> columns_of(const std::string& table) {
  std::istringstream lines(table);
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> columns;
  std::string line, cell;
  std::getline(lines, line);
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) names.push_back(cell);
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (const std::string& name : names) {
      EXPECT_TRUE(std::getline(cells, cell, ',')) << line;
      if (name != "date") columns[name].push_back(std::stod(cell));
    }
    EXPECT_TRUE(cells.eof()) << line;
  }
  return columns;
}

TEST_F(Curves, TableHasARowPerHundredthAndTheKnownValues) {
  auto table =
      columns_of(made("a.csv", " --set ageing.water=ample --set ageing.chlorophyll_content=31.5"));
  for (const auto& [name, values] : table) ASSERT_EQ(values.size(), 101u) << name;
  EXPECT_EQ(table["weathering_degree"][29], 0.29);
  EXPECT_EQ(table["water"], table["water_ample"]);
  // Anchors of models/ageing.
  EXPECT_EQ(table["water_standard"][40], 0.5);
  EXPECT_EQ(table["water_ample"][70], 0.5);
  EXPECT_EQ(table["water_cold"][50], 0.6);
  EXPECT_NEAR(table["chlorophyll"][50], 0.5, 1e-5);
  EXPECT_EQ(table["chlorophyll"], table["chlorophyll_standard"]);
  // Fresh moduli, and dry ones stiffer by 1 + b (1 - w).
  EXPECT_EQ(table["modulus_vein_pa"][0], 5e8);
  EXPECT_EQ(table["modulus_mesophyll_pa"][0], 5e6);
  EXPECT_NEAR(table["modulus_vein_pa"][100] / 5e8, 1.0 + 2.0 * (1.0 - 0.08), 1e-4);
  for (const std::string tissue : {"vein", "mesophyll"})
    EXPECT_NEAR(table["stress_" + tissue + "_pa"][50] / table["modulus_" + tissue + "_pa"][50],
                table["strain_" + tissue][50], 1e-5);
  // Fresh is green, straw is not; red is absorbed by chlorophyll, 740 nm is beyond the red edge.
  EXPECT_GT(table["colour_g_srgb"][0], 1.3 * table["colour_r_srgb"][0]);
  EXPECT_GT(table["colour_r_srgb"][100], table["colour_g_srgb"][100]);
  EXPECT_GT(table["colour_g_srgb"][100], table["colour_b_srgb"][100]);
  EXPECT_GT(table["reflectance_550nm"][0], 2.0 * table["reflectance_650nm"][0]);
  EXPECT_GT(table["reflectance_740nm"][0], 5.0 * table["reflectance_680nm"][0]);
  EXPECT_GT(table["reflectance_680nm"][100], table["reflectance_450nm"][100]);
}

TEST_F(Curves, FigureHasItsPanelsAndEachSpectrumInItsColour) {
  const std::string figure = made("a.svg");
  for (const char* part :
       {"heath", "(a) Pigments", "(b) Water", "(c) Shrinkage", "(d) Stiffness", "(e) Droop",
        "(f) Reflectance", "standard (scene)", "drought", "ample", "carotenoids", "mesophyll",
        "vein", ">weathering degree<", ">wavelength (nm)<", ">Young's modulus (MPa)<"})
    EXPECT_THAT(figure, HasSubstr(part));
  EXPECT_THAT(figure, Not(HasSubstr("<script")));
  auto table = columns_of(made("a.csv"));
  for (const std::size_t row : {0, 25, 50, 75, 100}) {
    const auto channel = [&](const char* name) { return std::lround(255.0 * table[name][row]); };
    char colour[16];
    std::snprintf(colour, sizeof colour, "#%02lx%02lx%02lx", channel("colour_r_srgb"),
                  channel("colour_g_srgb"), channel("colour_b_srgb"));
    EXPECT_THAT(figure, HasSubstr(std::string("fill=\"") + colour)) << row;
    EXPECT_THAT(figure, HasSubstr(std::string("stroke=\"") + colour)) << row;
  }
}

TEST_F(Curves, WeatherGivesARowADayOfTheSeason) {
  std::string days = "# an autumn\ndate,tmin_c,tmax_c,precipitation_mm,note\n";
  for (int day = 1; day <= 30; ++day)
    if (day != 15) days += fmt::format("2003-09-{:02},8,18,2,mild\n", day);
  days += "2003-10-01,,,,\n2003-10-02,-12,-6,0,\n2003-10-03,-12,-6,20,snow\n2003-10-04,,,0,\n";
  write("days.csv", days);
  const std::string table = made("s.csv", " --weather days.csv");
  EXPECT_THAT(table, testing::StartsWith(
                         "date,greenness,weathering_degree,snow_depth_m,swe_mm\n2003-09-01,"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 35);
  EXPECT_THAT(table, HasSubstr("\n2003-09-15,"));
  // What falls on the third lies on the morning of the fourth.
  const auto columns = columns_of(table);
  const std::vector<double>& swe_mm = columns.at("swe_mm");
  EXPECT_NEAR(swe_mm[33] - swe_mm[32], 20.0, 1e-3);
  const std::string figure = made("s.svg", " --weather days.csv");
  for (const char* part : {"(a) Meadow", "weathering degree", "greenness", "(b) Depth of snow",
                           "(c) Water of the snow", "days since 2003-09-01"})
    EXPECT_THAT(figure, HasSubstr(part));
  write("bad.csv", "date,tmin_c,tmax_c\n2003-09-01,8,18\n");
  expect_failure("a.toml --out t.csv --weather bad.csv", 2,
                 "bad.csv:1:1: found no column \"precipitation_mm\"");
  expect_failure("a.toml --out t.csv --weather none.csv", 4, "none.csv");
}

TEST_F(Curves, FigureIsWellFormedXml) {
  if (!is_installed("xmllint")) GTEST_SKIP() << "xmllint is not installed";
  made("a.svg", " --set ageing.stiffening=0 --set 'ageing.water=[[0, 1], [1, 1]]'");
  EXPECT_EQ(shell("xmllint --noout a.svg").err, "");
}

TEST_F(Curves, SameSceneSameBytes) {
  for (const std::string kind : {".svg", ".csv"}) {
    const std::string first = made("a" + kind, " --set render.threads=1");
    EXPECT_EQ(made("b" + kind, " --set render.threads=2"), first);
    EXPECT_EQ(made("a" + kind), first) << "an older file is replaced";
    EXPECT_NE(made("c" + kind, " --set ageing.droop=1"), first);
  }
}

TEST_F(Curves, WrongUseIsExitCodeTwo) {
  const std::string expected = "expected a file name that ends in .svg (figure) or .csv (table)";
  expect_failure("a.toml", 2, "--out: found nothing, " + expected);
  expect_failure("a.toml --out a.png", 2, "--out: found \"a.png\", " + expected);
  expect_failure("a.toml --out svg", 2, "--out: found \"svg\", " + expected);
  expect_failure("--out a.svg", 2, "SCENE");
  expect_failure("missing.toml --out a.svg", 2, "missing.toml: cannot read the scene file");
  expect_failure("a.toml --out a.svg --set ageing.water=soggy", 2, "ageing.water: found");
}

TEST_F(Curves, UnwritableOutputIsExitCodeFourAndLeavesNothing) {
  expect_failure("a.toml --out nowhere/a.svg", 4, "cannot write nowhere/a.svg: No such file");
  make_folder(folder_ / "a.csv/in the way");
  expect_failure("a.toml --out a.csv", 4, "cannot write a.csv: ");
}

}  // namespace
}  // namespace wold::test
