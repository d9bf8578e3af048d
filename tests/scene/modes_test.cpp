#include "scene/modes.h"

#include <gtest/gtest.h>

namespace wold::scene {
namespace {

/// That `last`, the last enumerator, has the last word: none is missing, and none is too many.
template <Mode T>
void expect_last(T last, std::string_view word) {
  EXPECT_EQ(static_cast<std::size_t>(last) + 1, words_of(last).size()) << word;
  EXPECT_EQ(word_of(last), word);
}

TEST(Modes, HaveAWordForEachEnumerator) {
  expect_last(TerrainShape::mountain, "mountain");
  expect_last(ColourModel::melanin, "melanin");
  expect_last(DroopRule::elastica, "elastica");
  expect_last(AgeingMotion::points, "points");
  expect_last(WindPattern::tornado, "tornado");
  expect_last(GrassForm::points, "points");
  expect_last(Device::automatic, "auto");
  expect_last(SnowfallStrength::blizzard, "blizzard");
  expect_last(Law::paper, "paper");
  expect_last(CrystalChoice::aggregate, "aggregate");
  expect_last(CoverModel::none, "none");
  expect_last(CloudKind::cirrus, "cirrus");
  expect_last(CloudRepeat::paper, "paper");
  expect_last(CloudBody::volume, "volume");
  expect_last(CloudEventKind::light, "light");
  expect_last(CloudFade::paper, "paper");
}

TEST(Modes, AreInTheOrderOfTheirWords) {
  EXPECT_EQ(word_of(GrassForm::automatic), "auto");
  EXPECT_EQ(word_of(CloudKind::stratocumulus), "stratocumulus");
  EXPECT_EQ(word_of(CrystalChoice::plate), "plate");
  EXPECT_EQ(word_of(SnowfallStrength::moderate), "moderate");
  EXPECT_EQ(word_of(CloudEventKind::gather), "gather");
}

}  // namespace
}  // namespace wold::scene
