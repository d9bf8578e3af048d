#include "scene/old_names.h"

#include <gtest/gtest.h>

#include <regex>

#include "scene/parse.h"
#include "scene/problems.h"
#include "scene/registry.h"
#include "scene/write.h"

namespace wold::scene {
namespace {

/// What reading says of a scene file "a.toml" of that text, as a user reads it.
std::vector<std::string> warnings_of(const std::string& text, const Overrides& overrides = {}) {
  std::vector<std::string> messages;
  for (const Problem& warning : parse_located_scene(text, "a.toml", overrides).warnings)
    messages.push_back(to_string(warning));
  return messages;
}

/// Whether a key of that dotted name, without an item's number, is in the registry.
bool is_key(std::string_view name) {
  if (find_key(name) != nullptr) return true;
  const TableArray* array = find_array(table_of(name));
  if (array == nullptr) return false;
  Scene scene;
  array->append(scene);
  return std::ranges::any_of(array->keys(0), [&](const Key& key) { return key.name == name; });
}

TEST(OldNames, LeadToKeysAndAreNone) {
  for (const OldName& renamed : old_names()) {
    EXPECT_TRUE(is_key(renamed.name)) << renamed.name;
    EXPECT_FALSE(is_key(renamed.old_name)) << renamed.old_name;
    EXPECT_EQ(std::ranges::count(old_names(), renamed.old_name, &OldName::old_name), 1)
        << renamed.old_name;
  }
}

TEST(OldNames, AreReadWithAWarningThatHasThePlaceAndTheNewName) {
  const std::string text = "[growth]\n  share = 0.5\n";
  EXPECT_EQ(parse_scene(text, "a.toml"), parse_scene("[growth]\ncover = 0.5\n", "a.toml"));
  EXPECT_EQ(warnings_of(text),
            std::vector<std::string>{
                "a.toml:2:3: growth.share is the old name of growth.cover; write cover = ..."});
  EXPECT_TRUE(warnings_of("[growth]\ncover = 0.5\n").empty());
}

TEST(OldNames, AreReadInItemsAndOnTheCommandLine) {
  const std::string events =
      "[[clouds]]\n[[cloud_events]]\nkind = 'gather'\n[[cloud_events]]\nkind = 'gather'\nstart = "
      "90\nby = 0.25\n";
  EXPECT_EQ(parse_scene(events, "a.toml"),
            parse_scene(std::regex_replace(events, std::regex("by"), "fraction"), "a.toml"));
  EXPECT_EQ(warnings_of(events),
            std::vector<std::string>{"a.toml:7:1: cloud_events[2].by is the old name of "
                                     "cloud_events[2].fraction; write fraction = ..."});
  const Overrides old = {"growth.share=0.25"};
  EXPECT_EQ(parse_scene("[growth]\ncover = 0.5\n", "a.toml", old),
            parse_scene("[growth]\ncover = 0.25\n", "a.toml"));
  ASSERT_EQ(warnings_of("", old).size(), 1u);
  expect_start(warnings_of("", old)[0], "--set growth.share=0.25: growth.share is the old name of");
}

TEST(OldNames, BesideTheNewOneAreAProblem) {
  expect_problem("[growth]\ncover = 0.5\nshare = 0.5\n",
                 "a.toml:3:1: growth.share: found the key again, by its old name; line 2 has it, "
                 "expected it once, as growth.cover");
  expect_problem("[growth]\nshare = 0.5\ncover = 0.5\n",
                 "a.toml:3:1: growth.cover: found the key again, by its present name; line 2");
  expect_problem("[growth]\nshare = 2\n",
                 "a.toml:2:9: growth.cover: found 2, expected a number from 0 to 1");
}

TEST(OldNames, AreNotWritten) {
  const std::string resolved = resolved_toml(parse_scene("[growth]\nshare = 0.5\n", "a.toml"));
  EXPECT_NE(resolved.find("\ncover = 0.5\n"), std::string::npos);
  EXPECT_EQ(resolved.find("\nshare = "), std::string::npos);
}

TEST(OldNames, AreNoAnswerToAMisspeltOne) {
  EXPECT_EQ(present_name("growth.shar"), "growth.shar");
  EXPECT_EQ(present_name("growth[1].share"), "growth[1].cover");
  EXPECT_EQ(present_name("[growth"), "[growth");
  EXPECT_EQ(present_name("]["), "][");
  EXPECT_EQ(present_name(""), "");
  expect_problem("[growth]\nshares = 0.5\n", "a.toml:2:1: unknown key \"growth.");
}

}  // namespace
}  // namespace wold::scene
