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
  EXPECT_THAT(complaint(""), HasSubstr("expected a key or a table"));
}

}  // namespace
}  // namespace wold::scene
