#include "mitsuba/grid_file.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <stdexcept>

namespace wold::mitsuba {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <class T>
std::string bytes_of(const glm::ivec3& voxels, const std::vector<T>& values) {
  const std::size_t count = static_cast<std::size_t>(voxels.x) *
                            static_cast<std::size_t>(voxels.y) * static_cast<std::size_t>(voxels.z);
  if (values.size() != count)
    throw std::invalid_argument(fmt::format("found {} values, expected {} of {} x {} x {} voxels",
                                            values.size(), count, voxels.x, voxels.y, voxels.z));
  constexpr std::int32_t type = 1, channels = sizeof(T) / sizeof(float);
  const std::int32_t numbers[] = {type, voxels.x, voxels.y, voxels.z, channels};
  constexpr float box[] = {0.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F};
  std::string bytes = "VOL\3";
  append(bytes, numbers, std::size(numbers));
  append(bytes, box, std::size(box));
  append(bytes, values.data(), values.size());
  return bytes;
}

}  // namespace

std::string grid_bytes(const glm::ivec3& voxels, const std::vector<float>& values) {
  return bytes_of(voxels, values);
}

std::string grid_bytes(const glm::ivec3& voxels, const std::vector<glm::vec3>& values) {
  return bytes_of(voxels, values);
}

}  // namespace wold::mitsuba
