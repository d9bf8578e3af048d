#include "core/files.h"

#include <gmock/gmock.h>

#include <cerrno>
#include <stdexcept>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace wold {
namespace {

namespace fs = std::filesystem;
using ::testing::EndsWith;
using ::testing::StartsWith;

/// What is said of a file whose writer fails with this errno and these words.
std::string said_of_writer(int error_number, const std::string& words) {
  const test::TemporaryFolder folder("files");
  const fs::path path = folder.path() / "file";
  try {
    write_file_by_path(path, [&](const fs::path& temporary) {
      EXPECT_TRUE(fs::exists(temporary));
      errno = error_number;
      throw std::runtime_error(words);
    });
  } catch (const FileError& error) {
    EXPECT_TRUE(fs::is_empty(folder.path()));
    EXPECT_THAT(error.what(), StartsWith("cannot write " + path.string() + ": "));
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

// Other threads, which failed as well, may have made room again before anyone looks at the disk.
TEST(WriteFile, TellsOfAFullDiskThatHasRoomAgain) {
  EXPECT_THAT(said_of_writer(ENOSPC, "unknown"), EndsWith(": No space left on device"));
  EXPECT_THAT(said_of_writer(EDQUOT, "unknown"), EndsWith(": Disk quota exceeded"));
}

TEST(WriteFile, TellsTheLibrarysWordsWhereTheDiskIsNotToBlame) {
  EXPECT_THAT(said_of_writer(0, "no such codec"), EndsWith(": no such codec"));
  EXPECT_THAT(said_of_writer(ENOENT, "no such codec"), EndsWith(": no such codec"));
}

}  // namespace
}  // namespace wold
