#pragma once

#include <filesystem>

#include "core/image.h"

namespace wold {

/// Writes an OpenEXR picture of half floats whose neighbouring pixels differ so much that packing
/// without loss saves nothing: in OpenEXR's B44, which needs no library whose versions choose other
/// bytes. The 16 numbers of 4 x 4 pixels take 14 bytes in place of 32, and each is true to a
/// thirtieth of the range of its block, in steps of half floats. Whole or not at all, the same
/// bytes for the same picture. Throws FileError.
void write_rough_picture(const std::filesystem::path& path, const Image& image);

}  // namespace wold
