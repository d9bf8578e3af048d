#include "grass/geometry/blade.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "small_meadow.h"

namespace wold::grass {
namespace {

TEST(ScatterBlades, DrawsTheSceneDistributionsOnePerCell) {
  scene::Grass grass;
  grass.blades = 2500;  // 50 x 50 cells
  const auto blades = scatter_blades(grass, {}, {grass.patch_m, grass.blades, 3, 1});
  ASSERT_EQ(blades.size(), 2500U);
  std::vector<int> taken(2500, 0);
  double length = 0.0;
  for (const Blade& blade : blades) {
    const glm::ivec2 cell(blade.root_m * static_cast<float>(50.0 / grass.patch_m));
    ++taken[static_cast<std::size_t>(cell.y * 50 + cell.x)];
    length += double{blade.length_m} / 2500.0;
  }
  EXPECT_EQ(std::count(taken.begin(), taken.end(), 1), 2500);
  // Standard error of the mean: 0.25 / sqrt(2500) = 0.5 %.
  EXPECT_NEAR(length / grass.height_m, 1.0, 0.02);
}

// The width is the whole one, of which a blade's radius is half.
TEST(ScatterBlades, AreAsWideAsAskedFor) {
  scene::Grass grass;
  grass.blades = 2500;
  double width = 0.0;
  for (const Blade& blade : scatter_blades(grass, {}, {grass.patch_m, grass.blades, 3, 1}))
    width += 2.0 * double{blade.radius_m} / 2500.0;
  EXPECT_NEAR(width / grass.width_m, 1.0, 0.03);
}

TEST(ScatterBlades, VariantsDiffer) {
  const scene::Grass grass;
  const auto a = scatter_blades(grass, {}, {grass.patch_m, grass.blades, 3, 0});
  const auto b = scatter_blades(grass, {}, {grass.patch_m, grass.blades, 3, 1});
  int same = 0;
  for (std::size_t i = 0; i < a.size(); ++i) same += a[i].length_m == b[i].length_m ? 1 : 0;
  EXPECT_LE(same, 40);  // both ends of the length's range are cut
}

}  // namespace
}  // namespace wold::grass
