#include "compare/compare_pair.h"

#include <fmt/format.h>

#include "compare/grid_pair.h"
#include "compare/picture_pair.h"

namespace wold::compare {
namespace fs = std::filesystem;
namespace {

Comparison compare_kind(FileKind kind, const fs::path& got, const fs::path& want,
                        const Limits& limits, const fs::path& evidence_folder) {
  switch (kind) {
    case FileKind::vdb:
      return compare_vdbs(got, want, limits);
    case FileKind::df3:
      return compare_df3s(got, want, limits);
    case FileKind::picture:
      break;
  }
  return compare_pictures(got, want, limits, evidence_folder);
}

Comparison of_two_kinds(FileKind got, FileKind want) {
  Comparison result;
  result.faults.push_back(fmt::format("got a {}, want a {}", to_string(got), to_string(want)));
  return result;
}

}  // namespace

Comparison compare_pair(const fs::path& got, const fs::path& want, const Limits& limits,
                        const fs::path& evidence_folder) {
  const FileKind kind = file_kind(got);
  const FileKind want_kind = file_kind(want);
  Comparison result = kind == want_kind ? compare_kind(kind, got, want, limits, evidence_folder)
                                        : of_two_kinds(kind, want_kind);
  result.name = got.filename().string();
  result.got = got;
  result.want = want;
  result.kind = to_string(kind);
  return result;
}

}  // namespace wold::compare
