#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "scene/parse.h"
#include "scene/write.h"

namespace wold::scene {
namespace {

enum class Outcome { scene, refused };

/// Anything but a scene or an InputError with at least one problem fails the test.
Outcome outcome_of(const std::string& text) {
  try {
    parse_scene(text, "damaged.toml");
    return Outcome::scene;
  } catch (const InputError& error) {
    EXPECT_FALSE(error.problems().empty());
    for (const Problem& problem : error.problems()) EXPECT_FALSE(problem.message.empty());
    return Outcome::refused;
  }
}

std::string mutated(std::string text, std::uint64_t index) {
  const std::string_view favourites = "[]{}=.,\"'#\n\\-0e\xff";
  for (std::uint64_t edit = 0; edit < 1 + index % 4; ++edit) {
    const auto below = [&](std::string_view purpose, std::size_t count) {
      return random_below({edit, key_of("mutation"), index, key_of(purpose)},
                          static_cast<std::uint32_t>(count));
    };
    const std::size_t place = below("place", text.size());
    switch (below("what", 4)) {
      case 0:
        text[place] = favourites[below("favourite", favourites.size())];
        break;
      case 1:
        text[place] = static_cast<char>(below("byte", 256));
        break;
      case 2:
        text.erase(place, 1 + below("length", 40));
        break;
      default:
        text.insert(place, text.substr(below("source", text.size()), below("length", 40)));
    }
  }
  return text;
}

TEST(DamagedScenes, TruncatedTextsParseOrAreRefused) {
  const std::string text = resolved_toml(Scene{});
  int refused = 0;
  for (std::size_t length = 0; length < text.size(); length += 7)
    refused += outcome_of(text.substr(0, length)) == Outcome::refused ? 1 : 0;
  EXPECT_GT(refused, 0);
}

TEST(DamagedScenes, MutatedTextsParseOrAreRefused) {
  const std::string text = resolved_toml(Scene{});
  int scenes = 0, refused = 0;
  for (std::uint64_t index = 0; index < 3000; ++index)
    (outcome_of(mutated(text, index)) == Outcome::scene ? scenes : refused) += 1;
  EXPECT_GT(scenes, 100);
  EXPECT_GT(refused, 100);
}

TEST(DamagedScenes, RandomBytesAreRefused) {
  for (std::uint64_t index = 0; index < 500; ++index) {
    std::string text(64, '\0');
    for (std::size_t i = 0; i < text.size(); ++i)
      text[i] = static_cast<char>(random_below({i, key_of("junk"), index, 0}, 256));
    EXPECT_EQ(outcome_of(text), Outcome::refused);
  }
}

}  // namespace
}  // namespace wold::scene
