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

/// The number of a process that has ended.
pid_t ended_process() {
  const pid_t process = ::fork();
  if (process == 0) ::_exit(0);
  ::waitpid(process, nullptr, 0);
  return process;
}

TEST(TemporaryName, OnlyWhatEndedProcessesLeftIsRemoved) {
  const TemporaryFolder folder("left");
  const std::string ended = std::to_string(ended_process());
  const std::string here = ".0001." + host_name() + ".";
  const std::string elsewhere = ".0001.node.of.a.farm.";
  const auto make = [&](const std::string& name) {
    make_folder((folder.path() / name).parent_path());
    write_file(folder.path() / name, "half");
    return folder.path() / name;
  };
  const fs::path left[] = {make(here + ended + ".tmp.png"),
                           make("a/" + here + ended + ".tmp"),
                           make(here + ended + ".tmp.pov-state"),
                           make("snow/.scratch." + host_name() + "." + ended + ".tmp/tile.tif"),
                           make(temporary_name("b.vdb")),
                           make(elsewhere + "1.tmp.png")};
  const fs::path kept[] = {make(here + "1.tmp.png"), make(elsewhere + ended + ".tmp.png"),
                           make("0001.png"), make(".tmp"), make(".mine.tmp.png")};
  for (const fs::path& old : {left[5], kept[2], kept[3], kept[4]})
    fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(24 * 30));
  remove_temporaries(folder.path());
  for (const fs::path& path : left) EXPECT_FALSE(fs::exists(path)) << path;
  for (const fs::path& path : kept) EXPECT_TRUE(fs::exists(path)) << path;
  EXPECT_FALSE(fs::exists(left[3].parent_path()));
}

}  // namespace
}  // namespace wold::test
