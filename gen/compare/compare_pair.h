#pragma once

#include "compare/comparison.h"

namespace wold::compare {

/// Compares two files of one kind, see compare_pictures(), compare_vdbs() and compare_df3s();
/// another kind is a fault. The folder for evidence may be empty: none. Throws FileError when a
/// file is missing or damaged or the evidence cannot be written.
Comparison compare_pair(const std::filesystem::path& got, const std::filesystem::path& want,
                        const Limits& limits, const std::filesystem::path& evidence_folder);

}  // namespace wold::compare
