#include "core/expected_picture.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold {
namespace {

TEST(ExpectedPicture, IsReadAsItWasWritten) {
  const test::TemporaryFolder folder("expected");
  const auto path = folder.path() / "expected.json";
  write_expected_picture(path, {{4, 2},
                                {{"grass", 0.85, {{3, {0.1F, 0.25F, 0.05F}, {0.5F, 0.4F, 0.3F}}}},
                                 {"clouds", 0.5, {}}}});
  const ExpectedPicture read = read_expected_picture(path);
  EXPECT_EQ(read.tiles, glm::ivec2(4, 2));
  ASSERT_EQ(read.things.size(), 2U);
  EXPECT_EQ(read.things[0].name, "grass");
  EXPECT_EQ(read.things[0].min_fraction, 0.85);
  ASSERT_EQ(read.things[0].tiles.size(), 1U);
  EXPECT_EQ(read.things[0].tiles[0].tile, 3);
  EXPECT_EQ(read.things[0].tiles[0].with, glm::vec3(0.1F, 0.25F, 0.05F));
  EXPECT_EQ(read.things[0].tiles[0].without, glm::vec3(0.5F, 0.4F, 0.3F));
  EXPECT_TRUE(read.things[1].tiles.empty());
}

TEST(ExpectedPicture, DamageIsAFileErrorThatNamesIt) {
  const test::TemporaryFolder folder("expected_damage");
  const auto path = folder.path() / "expected.json";
  for (const char* text :
       {"", "{}", "[1, 2]", R"({"tiles": [0, 2], "things": []})",
        R"({"tiles": [2, 1], "things": [{"name": "grass", "least_share": 0.5, "tiles": [7]}]})",
        R"({"tiles": [2, 1], "things": [{"name": "grass", "least_share": 0.5,
            "tiles": [[2, [0, 0, 0], [1, 1, 1]]]}]})"}) {
    write_file(path, text);
    try {
      read_expected_picture(path);
      ADD_FAILURE() << "read " << text;
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("expected.json"), std::string::npos) << text;
    }
  }
  EXPECT_THROW(read_expected_picture(folder.path() / "nowhere.json"), FileError);
}

}  // namespace
}  // namespace wold
