#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"

namespace wold::scene {

/// Where the user gave which keys, and which of these were wrong by themselves.
struct Places {
  std::map<std::string, SourcePosition> given;
  std::set<std::string> failed;
};

/// A rule about several keys: the keys, those to blame first, whether it holds, and what to say.
struct Rule {
  std::vector<std::string> keys;
  bool holds;
  std::string message;
};

/// Adds a problem for each rule that does not hold, at the first of its keys that was given. Rules
/// about keys that failed by themselves are not judged.
void report_broken(const std::vector<Rule>& rules, const Places& places,
                   std::vector<Problem>& problems);

/// Puts problems into the order of the text, those without a line at the end in the order they had.
void sort_by_line(std::vector<Problem>& problems);

/// Throws InputError with the problems, in the order of the text, then those without a line.
/// Without any it returns.
void throw_problems(std::vector<Problem> problems);

}  // namespace wold::scene
