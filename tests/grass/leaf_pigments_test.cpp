#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "core/error.h"
#include "grass/ageing/model_table.h"
#include "grass/optics/pigments.h"

namespace wold::grass {
namespace {

std::array<int, 3> srgb8(const glm::dvec3& linear) {
  std::array<int, 3> bytes{};
  for (int i = 0; i < 3; ++i)
    bytes[static_cast<std::size_t>(i)] =
        static_cast<int>(std::lround(255.0 * srgb_encoded(std::clamp(linear[i], 0.0, 1.0))));
  return bytes;
}

TEST(Pigments, WhiteUnderD65IsTheTabulatedOne) {
  struct Range {
    double first_nm, last_nm;
    glm::dvec3 white;
  };
  // ASTM E308: X 95.047, Z 108.883; the cut ranges by summation of the CIE's tables.
  for (const Range& range : {Range{360.0, 780.0, {0.950465, 1.0, 1.088970}},
                             Range{380.0, 780.0, {0.950430, 1.0, 1.088801}},
                             Range{400.0, 750.0, {0.949983, 1.0, 1.086712}}}) {
    const auto count = static_cast<std::size_t>((range.last_nm - range.first_nm) / 5.0) + 1;
    const Observer observer = load_observer(range.first_nm, range.last_nm);
    const std::vector<double> perfect(count, 1.0);
    const glm::dvec3 white = observer.xyz(perfect);
    const glm::dvec3 rgb = observer.linear_srgb(perfect);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(white[i], range.white[i], 1e-6);
      EXPECT_NEAR(rgb[i], 1.0, 1e-12);
    }
  }
}

TEST(Pigments, ChlorophyllsAddUpAndDifferWhereTheyShould) {
  const LeafSpectra leaf = load_leaf_spectra();
  ASSERT_EQ(leaf.wavelength_nm.size(), 77U);
  for (std::size_t i = 0; i < leaf.wavelength_nm.size(); ++i) {
    EXPECT_EQ(leaf.wavelength_nm[i], 400.0 + 5.0 * static_cast<double>(i));
    const double sum = 0.75 * leaf.chlorophyll_a_cm2_ug[i] + 0.25 * leaf.chlorophyll_b_cm2_ug[i];
    EXPECT_NEAR(sum, leaf.chlorophyll_cm2_ug[i], 1e-5 * leaf.chlorophyll_cm2_ug[i] + 1e-12);
  }
  EXPECT_GT(leaf.chlorophyll_a_cm2_ug[55] / leaf.chlorophyll_b_cm2_ug[55], 10.0);  // 675 nm
  EXPECT_GT(leaf.chlorophyll_b_cm2_ug[14] / leaf.chlorophyll_a_cm2_ug[14], 10.0);  // 470 nm
  EXPECT_EQ(leaf.carotenoid_cm2_ug[60], 0.0);                                      // 700 nm
}

TEST(Pigments, PaperSubtractionGivesItsPaleColours) {
  const LeafSpectra leaf = load_leaf_spectra();
  const Observer observer = load_observer(400.0, 780.0);
  // Without the scale to white, as the expected bytes were calculated.
  const auto colour = [&](double chlorophyll) {
    return srgb8(srgb_from_xyz(observer.xyz(paper_reflectance(leaf, chlorophyll))));
  };
  EXPECT_EQ(colour(1.0), (std::array{220, 249, 168}));
  EXPECT_EQ(colour(0.5), (std::array{239, 251, 210}));
  EXPECT_EQ(colour(0.0), (std::array{255, 254, 243}));
}

TEST(ModelTable, RefusesDamagedFiles) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "wold_leaf_damaged.toml";
  EXPECT_THROW(ModelTable("no/such/file.toml"), FileError);
  for (const char* text : {"a = [1, 2", "a = [1, \"two\"]", "a = 1", "a = []"}) {
    std::ofstream(file) << text;
    EXPECT_THROW(ModelTable{file}, FileError) << text;
  }
  std::ofstream(file) << "a = [1, 2.5]";
  const ModelTable table(file);
  EXPECT_EQ(table.column("a", 2), (std::vector<double>{1.0, 2.5}));
  EXPECT_THROW(table.column("a", 3), FileError);
  EXPECT_THROW(table.column("b"), FileError);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace wold::grass
