#include "work/file_states.h"

#include <gtest/gtest.h>

#include <chrono>

#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold::work {
namespace {

namespace fs = std::filesystem;

class FileStatesOfAFolder : public testing::Test {
 protected:
  /// Later than at the last call, whatever the file system's clock can tell apart.
  void write(const std::string& text) {
    write_file(path_, text);
    later_ += std::chrono::seconds(2);
    fs::last_write_time(path_, begin_ + later_);
  }

  test::TemporaryFolder folder_{"file_states"};
  fs::path path_ = folder_.path() / "a.txt";
  fs::file_time_type begin_ = fs::file_time_type::clock::now();
  std::chrono::seconds later_{0};
  FileStates states_{folder_.path()};
};

TEST_F(FileStatesOfAFolder, AFileOfTheSameSizeThatWasWrittenLaterIsReadAnew) {
  write("frost");
  const FileState before = states_.of("a.txt");
  write("thaws");
  const FileState after = states_.of("a.txt");
  EXPECT_EQ(after.bytes, before.bytes);
  EXPECT_NE(after.hash, before.hash);
  EXPECT_FALSE(states_.is_still("a.txt", before));
}

TEST_F(FileStatesOfAFolder, AFileThatWasWrittenAgainWithTheSameBytesIsStillTheSame) {
  write("frost");
  const FileState before = states_.of("a.txt");
  write("frost");
  EXPECT_TRUE(states_.is_still("a.txt", before));
}

TEST_F(FileStatesOfAFolder, WhatWasLearntIsBelievedWithoutReading) {
  write("frost");
  FileState known = states_.of("a.txt");
  known.hash = "of another time";
  states_.learn("a.txt", known);
  EXPECT_EQ(states_.of("a.txt").hash, "of another time");
}

}  // namespace
}  // namespace wold::work
