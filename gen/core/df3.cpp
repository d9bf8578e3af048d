#include "core/df3.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/files.h"

namespace wold {
namespace {

// Layout (POV-Ray 3.7 reference 3.5.11.12), all integers unsigned and big-endian:
//   offset  bytes  what
//   0       2      size x
//   2       2      size y
//   4       2      size z
//   6       b xyz  values, x fastest, then y, then z; b = 1, 2 or 4, known from the length alone
constexpr std::size_t header_bytes = 6;

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (char byte : bytes) value = (value << 8) | static_cast<unsigned char>(byte);
  return value;
}

glm::ivec3 header_size(const std::string& name, std::string_view bytes) {
  if (bytes.size() < header_bytes)
    throw FileError(fmt::format("{} is damaged: a df3 header has {} bytes, the file has {}", name,
                                header_bytes, bytes.size()));
  const glm::ivec3 size(big_endian(bytes.substr(0, 2)), big_endian(bytes.substr(2, 2)),
                        big_endian(bytes.substr(4, 2)));
  if (size.x == 0 || size.y == 0 || size.z == 0)
    throw FileError(
        fmt::format("{} is damaged: its header says {} x {} x {}, every side must be at least 1",
                    name, size.x, size.y, size.z));
  return size;
}

/// Bytes per value, from the length of the file.
std::size_t value_bytes(const std::string& name, glm::ivec3 size, std::size_t found) {
  const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                            static_cast<std::size_t>(size.z);
  for (std::size_t width : {1U, 2U, 4U})
    if (found == width * count) return width;
  throw FileError(fmt::format(
      "{} is damaged: its header says {} x {} x {}, so {}, {} or {} bytes of values (8, 16 or 32 "
      "bit) were expected, {} found",
      name, size.x, size.y, size.z, count, 2 * count, 4 * count, found));
}

void check_writable(glm::ivec3 size, std::size_t values, float scale, int bits) {
  if (std::min({size.x, size.y, size.z}) < 1 || std::max({size.x, size.y, size.z}) > 65535)
    throw std::invalid_argument(fmt::format(
        "a df3 file has sides from 1 to 65535, got {} x {} x {}", size.x, size.y, size.z));
  const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
                            static_cast<std::size_t>(size.z);
  if (values != count)
    throw std::invalid_argument(fmt::format("a df3 file of {} x {} x {} needs {} values, got {}",
                                            size.x, size.y, size.z, count, values));
  if (bits != 8 && bits != 16)
    throw std::invalid_argument(fmt::format("a df3 value has 8 or 16 bits, not {}", bits));
  if (!(scale > 0.0F))
    throw std::invalid_argument(fmt::format("a df3 file needs a positive scale, got {}", scale));
}

void append_big_endian(std::string& bytes, std::uint32_t value, int bits) {
  for (int shift = bits - 8; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<char>((value >> shift) & 0xFFU));
}

}  // namespace

Df3 read_df3(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  const std::string name = path.string();
  Df3 grid;
  grid.size = header_size(name, bytes);
  const std::string_view stored = std::string_view(bytes).substr(header_bytes);
  const std::size_t width = value_bytes(name, grid.size, stored.size());
  grid.bits = static_cast<int>(8 * width);
  grid.values.reserve(stored.size() / width);
  const double largest = static_cast<double>((std::uint64_t{1} << grid.bits) - 1);
  for (std::size_t at = 0; at < stored.size(); at += width)
    grid.values.push_back(static_cast<float>(big_endian(stored.substr(at, width)) / largest));
  return grid;
}

void write_df3(std::ostream& out, glm::ivec3 size, std::span<const float> values, float scale,
               int bits) {
  check_writable(size, values.size(), scale, bits);
  std::string bytes;
  bytes.reserve(header_bytes + values.size() * static_cast<std::size_t>(bits / 8));
  for (int side : {size.x, size.y, size.z})
    append_big_endian(bytes, static_cast<std::uint32_t>(side), 16);
  const auto largest = static_cast<float>((1U << bits) - 1U);
  for (float value : values) {
    const float fraction = std::clamp(value / scale, 0.0F, 1.0F);
    append_big_endian(bytes, static_cast<std::uint32_t>(std::lround(fraction * largest)), bits);
  }
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace wold
