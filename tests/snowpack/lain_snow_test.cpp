#include <gtest/gtest.h>

#include "snowpack/snow_layer.h"

namespace wold::snowpack {
namespace {

double density_kg_m3(double water_mm) { return water_mm / lain_snow(water_mm).depth_m; }

// A little is as it fell, much as in the snow pits of winters.
TEST(LainSnow, IsDenserTheMoreOfItLies) {
  EXPECT_NEAR(density_kg_m3(1.0), fresh_kg_m3(0.0), 3.0);
  EXPECT_NEAR(lain_snow(10.0).depth_m, 0.079, 0.001);
  EXPECT_NEAR(lain_snow(100.0).depth_m, 0.435, 0.002);
  EXPECT_NEAR(density_kg_m3(400.0), 300.0, 5.0);
  EXPECT_GT(lain_snow(110.0).depth_m, lain_snow(100.0).depth_m);
}

TEST(LainSnow, HasNoDepthWithoutWater) { EXPECT_EQ(lain_snow(0.0).depth_m, 0.0); }

}  // namespace
}  // namespace wold::snowpack
