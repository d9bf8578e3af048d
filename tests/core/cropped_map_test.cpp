#include "core/cropped_map.h"

#include <gtest/gtest.h>

namespace wold {
namespace {

/// 21 samples, a metre apart, from (10, 20) on.
FactorMap numbered() {
  FactorMap map(21, Square{{10.0, 20.0}, 20.0});
  for (int j = 0; j < 21; ++j)
    for (int i = 0; i < 21; ++i) map.at(i, j) = static_cast<float>(100 * j + i * i);
  return map;
}

void expect_same_on(const Square& area, const FactorMap& part, const FactorMap& map) {
  for (int j = 0; j <= 10; ++j)
    for (int i = 0; i <= 10; ++i) {
      const glm::dvec2 at_m = area.corner_m + area.size_m * glm::dvec2(i, j) / 10.0;
      EXPECT_NEAR(part.sample(at_m.x, at_m.y), map.sample(at_m.x, at_m.y), 1e-3F);
    }
}

TEST(Cropped, IsTheMapOnTheAreaAndNoLarger) {
  const FactorMap map = numbered();
  for (const glm::dvec2 corner_m : {glm::dvec2(13.3, 27.1), {10.0, 20.0}, {25.5, 22.0}}) {
    const Square area{corner_m, 3.9};
    const FactorMap part = cropped(map, area);
    EXPECT_LE(part.samples(), 6);
    EXPECT_DOUBLE_EQ(part.step_m(), 1.0);
    expect_same_on(area, part, map);
  }
}

TEST(Cropped, IsCutAtTheMapsBorder) {
  const FactorMap map = numbered();
  const FactorMap corner = cropped(map, {{27.5, -5.0}, 30.0});
  EXPECT_EQ(corner.samples(), 6);
  EXPECT_EQ(corner.at(5, 0), map.at(20, 0));
  const FactorMap beside = cropped(map, {{28.5, 38.5}, 30.0});
  EXPECT_EQ(beside.samples(), 3);
  EXPECT_EQ(beside.at(2, 2), map.at(20, 20));
  EXPECT_EQ(cropped(map, {{0.0, 0.0}, 100.0}).samples(), 21);
  EXPECT_EQ(cropped(map, {{100.0, 100.0}, 1.0}).samples(), 2);  // beyond it
}

}  // namespace
}  // namespace wold
