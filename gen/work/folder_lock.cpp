#include "work/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <thread>

#include "core/error.h"
#include "core/files.h"
#include "core/interrupt.h"
#include "core/temporary_name.h"
#include "work/own_folder.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::milliseconds patience{100};

/// Whether a path still names an open file: its last holder may have removed it.
bool is_name_of(const fs::path& path, int file) {
  struct stat named {
  }, open{};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(file, &open) == 0 &&
         named.st_dev == open.st_dev && named.st_ino == open.st_ino;
}

/// Whether the file has another name, too: it may be a file of somebody's elsewhere.
bool has_other_names(int file) {
  struct stat open {};
  return ::fstat(file, &open) == 0 && open.st_nlink > 1;
}

/// What the holder has written: "process 12 on host"; tasks write nothing.
std::string holder(const fs::path& path) {
  std::ifstream file(path);
  std::string text;
  std::getline(file, text);
  return text.empty() ? "running tasks" : text;
}

void write_holder(int file) {
  const std::string text = fmt::format("process {} on {}\n", ::getpid(), host_name());
  // It is for people only: a full disk shows soon enough.
  if (::write(file, text.data(), text.size()) < 0) return;
}

}  // namespace

FolderLock::FolderLock(const fs::path& folder, Access access, Progress& progress)
    : folder_(folder), path_(folder / "tasks" / "lock") {
  make_folder(folder);
  if (access == Access::alone)
    require_no_way_out(folder);
  else
    require_no_way_out(folder, std::array{fs::path("tasks")});
  for (bool said = false; !try_lock(access); said = true) {
    if (!said)
      progress.say(fmt::format("{} is in use by {}; waiting until it is free", folder.string(),
                               holder(path_)));
    if (interrupted()) throw InterruptedError();
    std::this_thread::sleep_for(patience);
  }
  if (access == Access::alone) write_holder(file_);
}

bool FolderLock::try_lock(Access access) {
  make_folder(path_.parent_path());
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (file_ < 0 && errno == ENOENT) return false;  // its last holder has just removed the folder
  if (file_ < 0)
    throw FileError(fmt::format("cannot write {}: {}", path_.string(), std::strerror(errno)));
  if (has_other_names(file_)) {
    ::close(file_);
    file_ = -1;
    throw FileError(
        fmt::format("cannot write {}: it is a hard link, another name of a file that may "
                    "lie elsewhere; remove it",
                    path_.string()));
  }
  const bool locked = ::flock(file_, (access == Access::alone ? LOCK_EX : LOCK_SH) | LOCK_NB) == 0;
  const bool unknown = !locked && errno != EWOULDBLOCK;
  if ((locked && is_name_of(path_, file_)) || unknown) return true;
  ::close(file_);
  file_ = -1;
  return false;
}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  std::error_code ignored;
  // Only the last holder gets it for itself.
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0 && is_name_of(path_, file_))
    fs::remove(path_, ignored);
  ::close(file_);
  // Where nothing was made nothing stays.
  remove_empty_folder(path_.parent_path());
  remove_empty_folder(folder_);
}

}  // namespace wold::work
