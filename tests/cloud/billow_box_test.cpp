#include "cloud/billow_box.h"

#include <gtest/gtest.h>

namespace wold::cloud {
namespace {

// Heads that are too fine to be seen count as much as they do on the mean (Billows::fine_at()).
TEST(BillowBox, HasTheMeanThatUnseenHeadsCountWith) {
  for (const std::uint64_t key : {1U, 7U}) {
    const BillowBox box(key);
    constexpr int side = 24;
    double sum = 0.0;
    for (int i = 0; i < side * side * side; ++i)
      sum += double{box.at((glm::vec3(i % side, i / side % side, i / (side * side)) + 0.5F) /
                           static_cast<float>(side))};
    EXPECT_NEAR(sum / (side * side * side), 0.7, 0.03) << key;
  }
}

}  // namespace
}  // namespace wold::cloud
