#include "work/file_states.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <optional>

#include "core/files.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

/// Size and time; nothing when it is no file.
std::optional<FileState> look_at(const fs::path& path) {
  struct stat seen {};
  if (::stat(path.c_str(), &seen) != 0 || !S_ISREG(seen.st_mode)) return std::nullopt;
  return FileState{static_cast<std::uintmax_t>(seen.st_size),
                   std::int64_t{seen.st_mtim.tv_sec} * 1'000'000'000 + seen.st_mtim.tv_nsec,
                   {}};
}

bool looks_like(const FileState& seen, const FileState& known) {
  return seen.bytes == known.bytes && seen.modified_ns == known.modified_ns;
}

}  // namespace

FileState FileStates::of(const std::string& name) {
  const auto seen = look_at(folder_ / name);
  {
    const std::lock_guard lock(mutex_);
    const auto known = known_.find(name);
    if (seen && known != known_.end() && looks_like(*seen, known->second)) return known->second;
  }
  const std::string bytes = read_file(folder_ / name);
  FileState state = {bytes.size(), seen ? seen->modified_ns : 0, content_hash(bytes)};
  learn(name, state);
  return state;
}

bool FileStates::is_still(const std::string& name, const FileState& then) {
  const auto seen = look_at(folder_ / name);
  if (!seen || seen->bytes != then.bytes) return false;
  return seen->modified_ns == then.modified_ns || of(name).hash == then.hash;
}

void FileStates::learn(const std::string& name, const FileState& state) {
  const std::lock_guard lock(mutex_);
  known_[name] = state;
}

}  // namespace wold::work
