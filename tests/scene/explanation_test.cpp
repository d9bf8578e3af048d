#include "scene/explanation.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "scene/parse.h"
#include "scene/registry.h"

namespace wold::scene {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Explanation, OfAKeyIsTomlWithMeaningRangeAndDefault) {
  const std::string text = explanation("sun.elevation");
  EXPECT_THAT(text, HasSubstr("[sun]\n# "));
  EXPECT_THAT(text, HasSubstr("from -4 to 90 deg"));
  EXPECT_THAT(text, Not(HasSubstr("azimuth")));
  EXPECT_EQ(parse_scene(text, "explained").sun, Scene{}.sun);
  EXPECT_THAT(explanation("seed"), testing::StartsWith("# "));
}

TEST(Explanation, OfATableHasAllOfItsKeys) {
  const std::string text = explanation("camera");
  for (const Key& key : registry()) {
    if (table_of(key.name) == "camera") {
      EXPECT_THAT(text, HasSubstr(std::string(leaf_of(key.name)) + " = ")) << key.name;
    }
  }
  EXPECT_EQ(parse_scene(explanation("clouds"), "explained").clouds.size(), 1U);
}

TEST(Explanation, KnowsOldNamesAndSaysWhatMayHaveBeenMeant) {
  EXPECT_EQ(explanation("ageing.variety"), explanation("ageing.pigment_spread"));
  const auto complaint = [](const char* name) {
    try {
      return explanation(name);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_THAT(complaint("sun.elevatoin"), HasSubstr("did you mean sun.elevation?"));
  EXPECT_THAT(complaint("suns"), HasSubstr("did you mean sun"));
  EXPECT_THAT(complaint("\x1b[2J"), Not(HasSubstr("\x1b")));
  EXPECT_THAT(complaint("nonsense"), HasSubstr("expected a key or a table of a scene, such as "
                                               "sun.elevation or sun; wold explain lists all"));
}

TEST(Explanation, NamesAllTablesAndWhatMayBeMeant) {
  const std::string all = explanation("");
  for (const char* line : {"[sun]: elevation, azimuth, ", "\n[[clouds]]: kind, ", "\n[weather]: "})
    EXPECT_THAT(all, HasSubstr(line));
  EXPECT_GT(keys_named("").size(), 200U);
  for (const char* word : {"snow", "snow.falling"})
    EXPECT_THAT([&] { explanation(word); }, testing::ThrowsMessage<InputError>(
                                                HasSubstr("did you mean snowfall or snow_cover?")))
        << word;
}

}  // namespace
}  // namespace wold::scene
