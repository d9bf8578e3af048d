#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace wold::cli {

/// DIR/manifest.json: every file of an output directory with its bytes, content hash, stage (the
/// folder that made it) and, for pictures, what they were made from and the seconds it took.
class Manifest {
 public:
  /// Reads the manifest of `folder`; a missing or damaged one is empty.
  explicit Manifest(std::filesystem::path folder);

  /// Whether `picture` (relative to the folder) exists and was made from `source`.
  bool is_current(const std::filesystem::path& picture, const std::string& source) const;

  /// Remembers a finished picture and writes the manifest.
  void add_picture(const std::filesystem::path& picture, const std::string& source, double seconds);

  /// Lists the folder's files as they are and writes DIR/manifest.json. Throws FileError.
  void write();

 private:
  struct Picture {
    std::string source;
    double seconds = 0.0;
  };
  /// A file as it was when it was read last: a film's data is not read again for every picture.
  struct Content {
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type changed;
    std::string hash;
  };
  const Content& content_of(const std::filesystem::path& relative);

  std::filesystem::path folder_;
  std::map<std::filesystem::path, Content> contents_;
  std::map<std::string, Picture> pictures_;
};

}  // namespace wold::cli
