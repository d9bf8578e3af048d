#pragma once

#include <filesystem>

#include "cloud/periodic_map.h"

namespace wold::cloud {

/// Larger pictures are refused: 8192 x 8192 pixels of four channels are a gigabyte.
inline constexpr int largest_picture_px = 8192;

/// Opacities in [0, 1] of a user's picture, any that OpenImageIO reads: its alpha, or the
/// luminance of its values as stored when it has none or is opaque everywhere. Numbers that are
/// not finite count as clear. At most max_px a side: larger ones are averaged down. Made to tile:
/// where opposite edges differ more than any neighbours do, an eighth of the picture at its east
/// and north is cross-faded into the other side and cut off. One pixel is a veil of that opacity.
///
/// Throws FileError that names the file when it is missing, damaged or too large.
PeriodicMap<float> picture_opacity(const std::filesystem::path& path, int max_px);

}  // namespace wold::cloud
