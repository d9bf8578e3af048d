#pragma once

#include "compare/comparison.h"
#include "core/image.h"

namespace wold::compare {

/// Compares two pictures. Another size or number of channels is a fault. With a folder for
/// evidence they go there as got.png, want.png and, when the sizes agree, difference.png, which
/// shows 10 times the difference, and flip.png. Throws FileError when a file is missing or damaged
/// or the evidence cannot be written.
Comparison compare_pictures(const std::filesystem::path& got, const std::filesystem::path& want,
                            const Limits& limits, const std::filesystem::path& evidence_folder);

/// Puts a picture into a folder where a browser can show it: as PNG, with up to four channels.
Evidence shown_picture(const std::filesystem::path& folder, const std::string& caption,
                       const std::string& name, const Image& image);

}  // namespace wold::compare
