#pragma once

#include <deque>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace wold::render {

/// The renderer's own words on disk, line by line as they come, with the last ones at hand.
class Log {
 public:
  /// Starts an empty file, and its folder. Throws FileError.
  explicit Log(const std::filesystem::path& path);

  void add(std::string_view line);

  const std::filesystem::path& path() const { return path_; }
  /// The last lines, indented, each with a line break before it.
  std::string last_lines() const;

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::deque<std::string> last_;
};

/// Cuts a stream of bytes into lines. Line feeds and carriage returns both end one; empty ones
/// are dropped.
class LineSplitter {
 public:
  void add(std::string_view bytes) { rest_ += bytes; }
  /// Takes the next whole line; with `at_end` also the last, unended one. False when none is left.
  bool next(std::string& line, bool at_end = false);

 private:
  std::string rest_;
};

}  // namespace wold::render
