#pragma once

#include <filesystem>

namespace wold::film {

/// A name for a folder in `parent` that is this process's alone; whoever needs the folder makes it.
/// With the object it goes, and the parent with it when nothing else is in there.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::filesystem::path& parent);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace wold::film
