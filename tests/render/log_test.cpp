#include "render/log.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.h"
#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold::test {
namespace {

namespace fs = std::filesystem;
using render::LineSplitter;
using render::Log;

std::vector<std::string> lines_of(LineSplitter& splitter, bool at_end = false) {
  std::vector<std::string> lines;
  for (std::string line; splitter.next(line, at_end);) lines.push_back(line);
  return lines;
}

using Lines = std::vector<std::string>;

TEST(LineSplitter, BothEndsOfLinesCutAndEmptyOnesAreDropped) {
  LineSplitter splitter;
  splitter.add("one\ntwo\r\n\nthr");
  EXPECT_EQ(lines_of(splitter), (Lines{"one", "two"}));
  splitter.add("ee\rfour");
  EXPECT_EQ(lines_of(splitter), Lines{"three"});
  EXPECT_EQ(lines_of(splitter, true), Lines{"four"});
  EXPECT_EQ(lines_of(splitter, true), Lines{});
}

TEST(LineSplitter, ByteByByteIsTheSame) {
  LineSplitter splitter;
  Lines lines;
  for (const char c : std::string("a\n\nbc\rd\n")) {
    splitter.add({&c, 1});
    for (std::string& line : lines_of(splitter)) lines.push_back(std::move(line));
  }
  EXPECT_EQ(lines, (Lines{"a", "bc", "d"}));
}

TEST(LineSplitter, ALineWithoutEndIsCutAndNothingIsLost) {
  LineSplitter splitter;
  std::size_t bytes = 0;
  const std::string part(1 << 20, 'x');
  for (int i = 0; i < 50; ++i) {  // quadratic splitting would take minutes
    splitter.add(part);
    for (const std::string& line : lines_of(splitter)) {
      EXPECT_EQ(line.size(), LineSplitter::longest_line);
      bytes += line.size();
    }
  }
  for (const std::string& line : lines_of(splitter, true)) bytes += line.size();
  EXPECT_EQ(bytes, 50 * part.size());
}

TEST(Log, EndsWhereItHasGrownLongEnough) {
  const TemporaryFolder folder("log");
  const fs::path path = folder.path() / "render.log";
  Log log(path);
  const std::string line(4000, 'x');
  for (std::size_t bytes = 0; bytes < 2 * Log::max_bytes; bytes += line.size()) log.add(line);
  log.add("the last");
  EXPECT_LE(fs::file_size(path), Log::max_bytes + 100);
  EXPECT_TRUE(read_file(path).ends_with("the rest is left out\n"));
  EXPECT_TRUE(log.last_lines().ends_with("the last"));
}

TEST(Log, DoesNotFollowALink) {
  const TemporaryFolder folder("log_link");
  write_file(folder.path() / "mine", "mine");
  fs::create_symlink("mine", folder.path() / "render.log");
  EXPECT_THROW(Log(folder.path() / "render.log"), FileError);
  EXPECT_EQ(read_file(folder.path() / "mine"), "mine");
}

}  // namespace
}  // namespace wold::test
