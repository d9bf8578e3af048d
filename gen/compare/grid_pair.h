#pragma once

#include "compare/comparison.h"

namespace wold::compare {

/// Compares the grids of two OpenVDB files by name. A grid that is only in one, another type or
/// transform is a fault. Throws FileError when a file is missing or damaged.
Comparison compare_vdbs(const std::filesystem::path& got, const std::filesystem::path& want,
                        const Limits& limits);

/// Compares two POV-Ray density files, of any bits per value; another size is a fault. Throws
/// FileError when a file is missing or damaged.
Comparison compare_df3s(const std::filesystem::path& got, const std::filesystem::path& want,
                        const Limits& limits);

}  // namespace wold::compare
