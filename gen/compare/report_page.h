#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "compare/comparison.h"

namespace wold::compare {

/// Writes an HTML page of comparisons for people: got and wanted pictures to flip between, their
/// differences, the metrics and the limits. The page refers to the evidence, which lies in its
/// folder or below. Comparisons that differ are open, so is a single one. Throws FileError.
void write_report_page(const std::filesystem::path& page,
                       const std::vector<Comparison>& comparisons);

/// Whether a file with this text was written by write_report_page().
bool is_report_page(std::string_view text);

}  // namespace wold::compare
