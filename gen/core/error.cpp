#include "core/error.h"

#include <fmt/format.h>

namespace wold {
namespace {

std::string joined(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += to_string(problem);
  }
  return text;
}

Problem unplaced(const std::string& message) {
  Problem problem;
  problem.message = message;
  return problem;
}

}  // namespace

std::string to_string(const Problem& problem) {
  const SourcePosition& where = problem.where;
  if (where.file.empty()) return problem.message;
  if (where.line == 0) return fmt::format("{}: {}", where.file, problem.message);
  return fmt::format("{}:{}:{}: {}", where.file, where.line, where.column, problem.message);
}

InputError::InputError(std::vector<Problem> problems)
    : Error(ExitCode::wrong_input, joined(problems)), problems_(std::move(problems)) {}

InputError::InputError(const std::string& message)
    : InputError(std::vector<Problem>(1, unplaced(message))) {}

}  // namespace wold
