#include "core/normal_distribution.h"

#include <gtest/gtest.h>

namespace wold {
namespace {

TEST(NormalDistribution, HasItsPublishedQuantiles) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-12);
  EXPECT_NEAR(normal_quantile(0.5), 0.0, 1e-15);
  EXPECT_NEAR(normal_quantile(1e-9), -5.997807015008182, 1e-8);
  for (double probability = 1e-7; probability < 1.0; probability += 0.0137)
    EXPECT_NEAR(normal_cdf(normal_quantile(probability)), probability, 1e-13);
}

}  // namespace
}  // namespace wold
