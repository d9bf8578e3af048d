#pragma once

#include <filesystem>
#include <string>

#include "compare/differences.h"
#include "core/error.h"

namespace wold::compare {

/// What a comparison says.
struct Verdict {
  ExitCode code = ExitCode::done;  ///< or ExitCode::different
  std::string json;                ///< for programs; keys in a fixed order, a line break at the end
  std::string lines;               ///< for people: one line per file, those that differ first
};

/// Compares two files, see compare_pair(), or two folders: the pictures, .vdb and .df3 files of
/// both by their paths from there; what only one has is different.
///
/// The JSON of two files has what was compared, "same", the reasons against it, the limits and the
/// metrics; that of two folders "same" and a list of the former. With a report folder it goes to
/// metrics.json there, a page for people to index.html, and the pictures it shows beside it, those
/// of folders into numbered folders.
///
/// Throws FileError when a file is missing or damaged or the report cannot be written, InputError
/// when one is a folder and the other is not.
Verdict compare_paths(const std::filesystem::path& got, const std::filesystem::path& want,
                      const Limits& limits, const std::filesystem::path& report_folder);

}  // namespace wold::compare
