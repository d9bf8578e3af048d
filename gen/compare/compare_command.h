#pragma once

#include <filesystem>
#include <string>

#include "compare/differences.h"
#include "core/error.h"

namespace wold::compare {

/// Compares two files of one kind: pictures, .vdb or .df3. ExitCode::done when they agree within
/// the limits, ExitCode::different otherwise: also for another kind, size, number of channels, set
/// of grids, grid type or transform, which no limit forgives.
///
/// `json_out` receives what was compared, "same", the reasons against it, the limits and the
/// metrics, with keys in a fixed order and a line break at the end. With a report folder the same
/// goes to metrics.json there, and pictures to got.png, want.png and, when the sizes agree,
/// difference.png, which shows 10 times the difference.
///
/// Throws FileError when a file is missing or damaged or the report cannot be written.
ExitCode compare_files(const std::filesystem::path& got, const std::filesystem::path& want,
                       const Limits& limits, const std::filesystem::path& report_folder,
                       std::string& json_out);

}  // namespace wold::compare
