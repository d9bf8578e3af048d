#include "render/short_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/log.h"

namespace wold::render {

bool has_succeeded(const Answer& answer) {
  return answer.end && answer.end->code == 0 && answer.end->signal == 0;
}

std::string how_it_ended(const Answer& answer) {
  return answer.end ? to_string(*answer.end)
                    : fmt::format("no answer after {} s", longest_answer.count());
}

std::string last_lines(const Answer& answer) {
  constexpr std::size_t max = 8;
  const std::size_t first = answer.lines.size() - std::min(max, answer.lines.size());
  std::string text;
  for (std::size_t i = first; i < answer.lines.size(); ++i) text += "\n    " + answer.lines[i];
  return text;
}

Answer ask(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
           const std::function<bool()>& interrupted) {
  LineSplitter splitter;
  Answer answer;
  answer.end = run_to_end(
      arguments, folder, {longest_answer}, [&](std::string_view bytes) { splitter.add(bytes); },
      interrupted);
  for (std::string line; splitter.next(line, /*at_end=*/true);) answer.lines.push_back(line);
  return answer;
}

}  // namespace wold::render
