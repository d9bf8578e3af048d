#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <iosfwd>
#include <span>
#include <vector>

namespace wold {

/// A POV-Ray density file in memory. values[(z * size.y + y) * size.x + x] is the stored integer
/// over the largest one of that width, so in [0, 1].
struct Df3 {
  glm::ivec3 size{0};
  int bits = 0;  ///< 8, 16 or 32 per value
  std::vector<float> values;
};

/// Reads a density file. Throws FileError that names the expected and the found length when it is
/// missing, has an empty side, or is not as long as its header says.
Df3 read_df3(const std::filesystem::path& path);

/// Writes size.x * size.y * size.z values (x fastest, then y, then z) as integers of 8 or 16 bits:
/// values / scale, rounded to nearest and clamped to [0, 1], times the largest integer. Reading
/// back gives value / scale within half a step. Throws std::invalid_argument that names both
/// numbers when the count is wrong, or when a side is not in [1, 65535], bits is neither 8 nor 16
/// or scale is not positive.
void write_df3(std::ostream& out, glm::ivec3 size, std::span<const float> values, float scale,
               int bits);

}  // namespace wold
