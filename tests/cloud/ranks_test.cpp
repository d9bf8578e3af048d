#include "cloud/ranks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/random.h"

namespace wold::cloud {
namespace {

TEST(Ranks, SpreadEvenlyOverAllFieldsInTheirOrder) {
  std::vector<PeriodicMap<float>> fields = {PeriodicMap<float>(16, 8), PeriodicMap<float>(5, 5)};
  std::vector<std::pair<float, float>> pairs;
  for (auto& field : fields)
    for (std::size_t i = 0; i < field.values().size(); ++i)
      field.values()[i] =
          static_cast<float>(random_normal({static_cast<std::uint64_t>(field.width()), 1, i, 0}));
  const auto ranks = ranked(fields);
  for (std::size_t f = 0; f < fields.size(); ++f)
    for (std::size_t i = 0; i < fields[f].values().size(); ++i)
      pairs.emplace_back(fields[f].values()[i], ranks[f].values()[i]);
  std::ranges::sort(pairs);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    EXPECT_FLOAT_EQ(pairs[i].second, static_cast<float>((i + 0.5) / pairs.size()));
}

TEST(Ranks, OfClearSkyRiseTowardsTheClouds) {
  PeriodicMap<float> field(64, 64);
  for (int y = 24; y < 40; ++y)
    for (int x = 24; x < 40; ++x) field.at(x, y) = 1.0F;
  const auto ranks = ranked({field});
  EXPECT_GT(ranks[0].at(22, 32), ranks[0].at(18, 32));
  EXPECT_GT(ranks[0].at(32, 32), 1.0F - 16.0F * 16.0F / (64.0F * 64.0F));
}

TEST(Ranks, OfOnePixelAreItsMiddle) {
  EXPECT_FLOAT_EQ(ranked({PeriodicMap<float>(1, 1, 0.3F)})[0].at(0, 0), 0.5F);
}

}  // namespace
}  // namespace wold::cloud
