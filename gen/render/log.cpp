#include "render/log.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/files.h"

namespace wold::render {
namespace {

constexpr std::size_t lines_kept = 8;
constexpr std::string_view line_ends = "\r\n";

}  // namespace

Log::Log(const std::filesystem::path& path) : path_(path) {
  if (path.has_parent_path()) make_folder(path.parent_path());
  std::error_code ignored;
  if (std::filesystem::is_symlink(path, ignored))
    throw FileError(fmt::format("cannot write the log {}: it is a link", path.string()));
  // A new file: what has the name may be another name of a file elsewhere.
  std::filesystem::remove(path, ignored);
  file_.open(path, std::ios::binary);
  if (!file_) throw FileError(fmt::format("cannot write the log {}", path.string()));
}

void Log::add(std::string_view line) {
  const bool was_full = bytes_ > max_bytes;
  bytes_ += line.size() + 1;
  if (bytes_ <= max_bytes)
    file_ << line << std::endl;  // flushed: people watch it
  else if (!was_full)
    file_ << "... the rest is left out" << std::endl;
  last_.emplace_back(line);
  if (last_.size() > lines_kept) last_.pop_front();
}

std::string Log::last_lines() const {
  std::string text;
  for (const std::string& line : last_) text += "\n    " + line;
  return text;
}

void LineSplitter::add(std::string_view bytes) {
  rest_.erase(0, begin_);
  searched_ -= std::min(searched_, begin_);
  begin_ = 0;
  rest_ += bytes;
}

bool LineSplitter::next(std::string& line, bool at_end) {
  begin_ = std::min(rest_.find_first_not_of(line_ends, begin_), rest_.size());
  std::size_t end = rest_.find_first_of(line_ends, std::max(begin_, searched_));
  if (end == std::string::npos) searched_ = end = rest_.size();
  const bool is_ended = end < rest_.size() || end - begin_ >= longest_line;
  if (end == begin_ || (!is_ended && !at_end)) return false;
  end = std::min(end, begin_ + longest_line);
  line = rest_.substr(begin_, end - begin_);
  begin_ = end;
  return true;
}

}  // namespace wold::render
