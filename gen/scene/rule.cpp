#include "scene/rule.h"

#include <algorithm>
#include <tuple>

namespace wold::scene {
namespace {

SourcePosition blamed_place(const Rule& rule, const Places& places) {
  for (const std::string& key : rule.keys)
    if (const auto found = places.given.find(key); found != places.given.end())
      return found->second;
  return {};
}

}  // namespace

void sort_by_line(std::vector<Problem>& problems) {
  const auto rank = [](const Problem& problem) {
    return std::tuple(problem.where.line == 0, problem.where.line, problem.where.column);
  };
  std::ranges::stable_sort(problems, {}, rank);
}

void report_broken(const std::vector<Rule>& rules, const Places& places,
                   std::vector<Problem>& problems) {
  for (const Rule& rule : rules) {
    const bool judged = std::ranges::none_of(
        rule.keys, [&](const auto& key) { return places.failed.count(key) > 0; });
    if (judged && !rule.holds) problems.push_back({blamed_place(rule, places), rule.message});
  }
}

void throw_problems(std::vector<Problem> problems) {
  sort_by_line(problems);
  if (!problems.empty()) throw InputError(std::move(problems));
}

}  // namespace wold::scene
