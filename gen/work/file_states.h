#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>

namespace wold::work {

/// What a file was when somebody looked.
struct FileState {
  std::uintmax_t bytes = 0;
  std::int64_t modified_ns = 0;  ///< by the clock of the file system
  std::string hash;              ///< content_hash() of its bytes
};

/// The files of an output folder, by their names relative to it. Each is read once as long as its
/// size and time stay. Thread-safe.
class FileStates {
 public:
  explicit FileStates(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Throws FileError when it cannot be read.
  FileState of(const std::string& name);

  /// Whether it is there and has the bytes it had: same size and time, or else the same hash.
  bool is_still(const std::string& name, const FileState& then);

  /// Believes what was seen before, as long as size and time stay.
  void learn(const std::string& name, const FileState& state);

 private:
  std::filesystem::path folder_;
  std::mutex mutex_;
  std::map<std::string, FileState> known_;
};

}  // namespace wold::work
