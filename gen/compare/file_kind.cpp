#include "compare/file_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

#include "core/error.h"
#include "core/files.h"

namespace wold::compare {
namespace {

// openvdb/version.h, OPENVDB_MAGIC, as it lies on the disk.
constexpr std::string_view vdb_magic = " BDV";

bool starts_like_vdb(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, vdb_magic.size()> first{};
  file.read(first.data(), first.size());
  return file && std::string_view(first.data(), first.size()) == vdb_magic;
}

}  // namespace

const char* to_string(FileKind kind) {
  switch (kind) {
    case FileKind::vdb:
      return "vdb";
    case FileKind::df3:
      return "df3";
    case FileKind::picture:
      break;
  }
  return "picture";
}

FileKind file_kind(const std::filesystem::path& path) {
  require_regular_file(path);
  if (path.extension() == ".vdb" || starts_like_vdb(path)) return FileKind::vdb;
  return path.extension() == ".df3" ? FileKind::df3 : FileKind::picture;
}

bool is_named_comparable(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 6> endings = {".png", ".exr", ".hdr",
                                                       ".tif", ".vdb", ".df3"};
  return std::ranges::find(endings, path.extension().string()) != endings.end();
}

}  // namespace wold::compare
