#include "core/ground_map.h"

#include <gtest/gtest.h>

namespace wold {
namespace {

FactorMap rising(int samples) {
  FactorMap map(samples, 8.0);
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      map.at(i, j) = static_cast<float>(1.0 + 0.5 * at_m.x + 0.25 * at_m.y);
    }
  return map;
}

// In place or not, with a coarser, an equal and a finer factor.
TEST(Product, OfAMapThatGoesIsThatOfOneThatStays) {
  const FactorMap map = rising(17);
  for (const int samples : {5, 17, 33}) {
    const FactorMap factor = rising(samples);
    const FactorMap kept = product(map, factor);
    const FactorMap moved = product(FactorMap(map), factor);
    ASSERT_EQ(moved.samples(), kept.samples());
    for (std::size_t k = 0; k < kept.values().size(); ++k)
      ASSERT_NEAR(moved.values()[k], kept.values()[k], 1e-5F * kept.values()[k]) << samples;
    EXPECT_NEAR(kept.sample(8.0, 8.0), 49.0F, 1e-3F);
  }
}

}  // namespace
}  // namespace wold
