#pragma once

#include <deque>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace wold::render {

/// The renderer's own words on disk, line by line as they come, with the last ones at hand. A
/// renderer that never stops talking does not fill the disk: what is beyond max_bytes is left out.
class Log {
 public:
  static constexpr std::size_t max_bytes = std::size_t{16} << 20;

  /// Starts an empty file, and its folder. Throws FileError, also where a link lies in its place.
  explicit Log(const std::filesystem::path& path);

  void add(std::string_view line);

  const std::filesystem::path& path() const { return path_; }
  /// The last lines, indented, each with a line break before it.
  std::string last_lines() const;

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::size_t bytes_ = 0;
  std::deque<std::string> last_;
};

/// Cuts a stream of bytes into lines. Line feeds and carriage returns both end one; empty ones
/// are dropped, and longer ones cut at longest_line bytes.
class LineSplitter {
 public:
  static constexpr std::size_t longest_line = 4096;

  void add(std::string_view bytes);
  /// Takes the next whole line; with `at_end` also the last, unended one. False when none is left.
  bool next(std::string& line, bool at_end = false);

 private:
  std::string rest_;
  std::size_t begin_ = 0;     ///< of what has not been taken
  std::size_t searched_ = 0;  ///< up to where there is no end of a line after `begin_`
};

}  // namespace wold::render
