#include "core/temporary_name.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/file_list.h"
#include "core/files.h"
#include "support/temporary_folder.h"

namespace wold::test {
namespace {

namespace fs = std::filesystem;

/// What a process on this machine that has ended since then called its neighbour of a file.
fs::path name_of_ended_process(const fs::path& path) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t process = ::fork();
  if (process == 0) {
    const std::string name = temporary_name(path).filename().string();
    ::_exit(::write(ends[1], name.data(), name.size()) < 0);
  }
  ::waitpid(process, nullptr, 0);
  char name[256] = {};
  EXPECT_GT(::read(ends[0], name, sizeof name - 1), 0);
  ::close(ends[0]);
  ::close(ends[1]);
  return path.parent_path() / name;
}

/// A name as a process with that number on another machine would have given.
std::string name_elsewhere(pid_t process) {
  const std::string text = "0001.node.of.a.farm." + std::to_string(process) + ".0123456789abcdef";
  return "." + text + content_hash(text).substr(0, 8) + ".tmp.png";
}

std::string text_of(const fs::path& path) { return path.filename().string(); }

TEST(TemporaryName, OnlyWhatEndedProcessesLeftIsRemoved) {
  const TemporaryFolder folder("left");
  const auto make = [&](const fs::path& name) {
    make_folder((folder.path() / name).parent_path());
    write_file(folder.path() / name, "half");
    return folder.path() / name;
  };
  const fs::path left[] = {make(name_of_ended_process("0001.png")),
                           make(name_of_ended_process("a/0001")),
                           make(name_of_ended_process("0001.pov-state")),
                           make(name_of_ended_process("snow/scratch") / "tile.tif"),
                           make(temporary_name("b.vdb")),
                           make(name_elsewhere(1))};
  const fs::path kept[] = {make(name_elsewhere(2)), make("0001.png"), make(".tmp"),
                           make(".mine.tmp.png")};
  for (const fs::path& old : {left[5], kept[1], kept[2], kept[3]})
    fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(24 * 30));
  remove_temporaries(folder.path());
  for (const fs::path& path : left) EXPECT_FALSE(fs::exists(path)) << path;
  for (const fs::path& path : kept) EXPECT_TRUE(fs::exists(path)) << path;
  EXPECT_FALSE(fs::exists(left[3].parent_path()));
}

TEST(TemporaryName, UsersFilesOfSuchNamesStay) {
  const TemporaryFolder folder("users");
  const std::string host = host_name();
  std::string changed = text_of(name_of_ended_process("0001.png"));
  changed[1] = '2';
  for (const std::string& name :
       {".notes." + host + ".999999.tmp.png", std::string(".notes.tmp"),
        ".a.b." + host + ".999999.0123456789abcdef01234567.tmp", changed}) {
    write_file(folder.path() / name, "mine");
    EXPECT_FALSE(is_left_behind(folder.path() / name)) << name;
  }
}

TEST(TemporaryName, IsNewEveryTimeAndNeverTooLong) {
  const fs::path path = std::string(250, 'n') + ".png";
  EXPECT_NE(temporary_name(path), temporary_name(path));
  EXPECT_LT(text_of(temporary_name(path)).size(), 256U);
  EXPECT_EQ(temporary_name(path).extension(), ".png");
}

}  // namespace
}  // namespace wold::test
