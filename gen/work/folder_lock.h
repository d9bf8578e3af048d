#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/progress.h"

namespace wold::work {

/// `shared`: single tasks, which may work side by side. `alone`: a command that does all that is
/// missing and lists the files.
enum class Access { shared, alone };

/// The right to work in an output folder, held while it lives: DIR/tasks/lock, which goes with its
/// last holder and names the process that has the folder to itself. Waits for others; says so once
/// to `progress`. Where the file system knows no locks there are none: tasks do not need them.
class FolderLock {
 public:
  /// Makes the folder. Throws FileError, also where a link leads out of it (own_folder.h), and
  /// InterruptedError when the user stops the waiting. `shared` looks for such a link only on the
  /// way to the lock: whoever asks for it looks at the folders that it writes to.
  FolderLock(const std::filesystem::path& folder, Access access, Progress& progress);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  bool try_lock(Access access);

  std::filesystem::path folder_;
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace wold::work
