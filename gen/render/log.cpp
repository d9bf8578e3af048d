#include "render/log.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"

namespace wold::render {
namespace {

constexpr std::size_t lines_kept = 8;
constexpr std::string_view line_ends = "\r\n";

}  // namespace

Log::Log(const std::filesystem::path& path) : path_(path) {
  if (path.has_parent_path()) make_folder(path.parent_path());
  file_.open(path, std::ios::binary);
  if (!file_) throw FileError(fmt::format("cannot write the log {}", path.string()));
}

void Log::add(std::string_view line) {
  file_ << line << std::endl;  // flushed: people watch it
  last_.emplace_back(line);
  if (last_.size() > lines_kept) last_.pop_front();
}

std::string Log::last_lines() const {
  std::string text;
  for (const std::string& line : last_) text += "\n    " + line;
  return text;
}

bool LineSplitter::next(std::string& line, bool at_end) {
  rest_.erase(0, rest_.find_first_not_of(line_ends));
  const std::size_t end = rest_.find_first_of(line_ends);
  if (end == std::string::npos && (!at_end || rest_.empty())) return false;
  line = rest_.substr(0, end);
  rest_.erase(0, line.size());
  return true;
}

}  // namespace wold::render
