#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace wold::fuzz {

/// A file in memory with some bytes, for readers that want a path.
class ScratchFile {
 public:
  ScratchFile(const std::uint8_t* bytes, std::size_t count) : file_(memfd_create("input", 0)) {
    if (file_ < 0 || write(file_, bytes, count) != static_cast<ssize_t>(count)) std::abort();
  }
  ~ScratchFile() { close(file_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

}  // namespace wold::fuzz
