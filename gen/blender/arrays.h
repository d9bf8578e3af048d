#pragma once

#include <bit>
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/files.h"

namespace wold::blender {

static_assert(std::endian::native == std::endian::little, "the arrays are written as they lie");

/// Writes the bytes of a list as they lie: a raw little-endian array. Throws FileError.
template <class T>
void write_array(const std::filesystem::path& path, const std::vector<T>& values) {
  write_file(path, std::string_view(reinterpret_cast<const char*>(values.data()),
                                    values.size() * sizeof(T)));
}

}  // namespace wold::blender
