#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.h"
#include "scene/parse.h"

namespace wold::scene {

using Overrides = std::vector<std::string>;

/// What is wrong with a scene file "a.toml" of that text, as a user reads it.
inline std::vector<std::string> problems_of(const std::string& text,
                                            const Overrides& overrides = {}) {
  std::vector<std::string> messages;
  try {
    parse_scene(text, "a.toml", overrides);
  } catch (const InputError& error) {
    for (const Problem& problem : error.problems()) messages.push_back(to_string(problem));
  }
  return messages;
}

inline void expect_start(const std::string& text, const std::string& start) {
  EXPECT_EQ(text.substr(0, start.size()), start);
}

/// The text has exactly one problem, which starts like this.
inline void expect_problem(const std::string& text, const std::string& start,
                           const Overrides& overrides = {}) {
  const auto problems = problems_of(text, overrides);
  ASSERT_EQ(problems.size(), 1u) << text;
  expect_start(problems[0], start);
}

}  // namespace wold::scene
