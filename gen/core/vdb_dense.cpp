#include "core/vdb_dense.h"

#include <fmt/format.h>
#include <openvdb/tools/Dense.h>

#include "core/error.h"
#include "core/vdb_file.h"

namespace wold {
namespace {

template <class Grid>
typename Grid::Ptr typed_grid(const std::filesystem::path& path, const std::string& name) {
  const auto grid = read_vdb_grid(path, name);
  if (auto typed = openvdb::gridPtrCast<Grid>(grid)) return typed;
  throw FileError(fmt::format("{}: grid \"{}\" holds {}, {} was expected", path.string(), name,
                              grid->valueType(), Grid::gridType()));
}

/// Fills the caller's memory in place: a fine volume is too large to be held twice.
template <class Value, class Grid>
std::vector<Value> dense_values(const Grid& grid, glm::ivec3 first, glm::ivec3 size) {
  using Stored = typename Grid::ValueType;
  static_assert(sizeof(Value) == sizeof(Stored));
  const openvdb::Coord low(first.x, first.y, first.z);
  const openvdb::Coord high = low.offsetBy(size.x - 1, size.y - 1, size.z - 1);
  const openvdb::CoordBBox box(low, high);
  std::vector<Value> values(box.volume());
  openvdb::tools::Dense<Stored, openvdb::tools::LayoutXYZ> dense(
      box, reinterpret_cast<Stored*>(values.data()));
  openvdb::tools::copyToDense(grid, dense);
  return values;
}

}  // namespace

std::vector<float> read_dense_floats(const std::filesystem::path& path, const std::string& grid,
                                     glm::ivec3 first, glm::ivec3 size) {
  return dense_values<float>(*typed_grid<openvdb::FloatGrid>(path, grid), first, size);
}

std::vector<glm::vec3> read_dense_vectors(const std::filesystem::path& path,
                                          const std::string& grid, glm::ivec3 first,
                                          glm::ivec3 size) {
  return dense_values<glm::vec3>(*typed_grid<openvdb::Vec3SGrid>(path, grid), first, size);
}

}  // namespace wold
