#include "grass/texel/foreign_texel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/vdb_file.h"
#include "grass/texel/texel_file.h"

namespace wold::grass {
namespace fs = std::filesystem;
namespace {

/// What a message says of a wrong file.
class Complaint {
 public:
  Complaint(const char* key, const fs::path& path) : key_(key), path_(path) {}
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw InputError(
        fmt::format("{}: found {} {}, expected {}", key_, path_.string(), found, expected));
  }

 private:
  const char* key_;
  const fs::path& path_;
};

std::string names_of(const openvdb::GridPtrVec& grids) {
  std::vector<std::string> names;
  for (const openvdb::GridBase::Ptr& grid : grids)
    names.push_back(fmt::format("\"{}\" ({})", grid->getName(), grid->valueType()));
  return names.empty() ? "no grids" : fmt::format("the grids {}", fmt::join(names, ", "));
}

openvdb::FloatGrid::Ptr density_of(const openvdb::GridPtrVec& grids, const Complaint& complaint) {
  const auto grid =
      openvdb::gridPtrCast<openvdb::FloatGrid>(openvdb::findGridByName(grids, "density"));
  if (!grid) complaint.refuse("with " + names_of(grids), "a float grid \"density\", a fog volume");
  if (grid->getGridClass() == openvdb::GRID_LEVEL_SET)
    complaint.refuse("whose \"density\" is a level set", "a fog volume");
  if (!grid->hasUniformVoxels()) complaint.refuse("whose voxels are no cubes", "cubic voxels");
  if (grid->activeVoxelCount() > max_texel_voxels)
    complaint.refuse(fmt::format("with {} voxels", grid->activeVoxelCount()),
                     fmt::format("at most {}", max_texel_voxels));
  grid->tree().voxelizeActiveTiles();
  return grid;
}

/// A voxel that holds matter.
struct Matter {
  openvdb::Coord at;
  float density;
};

std::vector<Matter> matter_of(const openvdb::FloatGrid& grid, const Complaint& complaint) {
  std::vector<Matter> matter;
  for (auto it = grid.cbeginValueOn(); it; ++it) {
    if (!std::isfinite(*it)) complaint.refuse("with a density that is no number", "numbers");
    if (*it > 0.0F) matter.push_back({it.getCoord(), *it});
  }
  if (matter.empty()) complaint.refuse("without any density above 0", "a volume with matter");
  return matter;
}

/// The box of all that matters: its lowest corner, its sides.
struct Box {
  openvdb::Coord first;
  TexelShape shape;
};

Box box_of(const std::vector<Matter>& matter, double voxel_m, const Complaint& complaint) {
  openvdb::CoordBBox bounds;
  for (const Matter& voxel : matter) bounds.expand(voxel.at);
  const openvdb::Coord size = bounds.dim();
  const int side = std::max(size.x(), size.y());
  if (std::max(side, size.z()) > max_texel_side)
    complaint.refuse(fmt::format("of {} x {} x {} voxels", size.x(), size.y(), size.z()),
                     fmt::format("at most {} along an edge", max_texel_side));
  return {bounds.min(), {side, size.z(), voxel_m}};
}

/// Our own texels say how large their tile is, and that it begins at (1, 1, 1).
Box stated_or_own_box(const std::vector<Matter>& matter, double voxel_m, const fs::path& path,
                      const Complaint& complaint) {
  const Box own = box_of(matter, voxel_m, complaint);
  if (file_content(path).empty()) return own;
  const TexelShape stated = file_shape(path);
  const openvdb::Coord last =
      own.first + openvdb::Coord(own.shape.side, own.shape.side, own.shape.height);
  const bool fits = stated.side <= max_texel_side && stated.height <= max_texel_side &&
                    std::min({own.first.x(), own.first.y(), own.first.z()}) >= 1 &&
                    last.z() <= stated.height + 1 && own.shape.side <= stated.side &&
                    std::max(last.x(), last.y()) <= 2 * stated.side && stated.voxel_m > 0.0;
  if (!fits) complaint.refuse("whose voxels lie outside the size that it states", "a whole texel");
  return {openvdb::Coord(1), stated};
}

template <class Grid, class Value, class Read>
void read_values(const openvdb::GridPtrVec& grids, const char* name, const std::vector<Matter>& at,
                 std::vector<Value>& values, const Read& read) {
  const auto grid = openvdb::gridPtrCast<Grid>(openvdb::findGridByName(grids, name));
  if (!grid) return;
  const auto accessor = grid->getConstAccessor();
  for (std::size_t i = 0; i < at.size(); ++i) values[i] = read(accessor.getValue(at[i].at));
}

glm::vec3 unit_or(const openvdb::Vec3s& from, const glm::vec3& otherwise) {
  const glm::vec3 vector(from.x(), from.y(), from.z());
  const float length = glm::length(vector);
  return std::isfinite(length) && length > 1e-3F ? vector / length : otherwise;
}

}  // namespace

Texel read_any_texel(const fs::path& path, const char* key) {
  const Complaint complaint(key, path);
  const openvdb::GridPtrVecPtr grids = read_vdb(path);
  const openvdb::FloatGrid::Ptr density = density_of(*grids, complaint);
  std::vector<Matter> matter = matter_of(*density, complaint);
  const Box box = stated_or_own_box(matter, density->voxelSize().x(), path, complaint);
  Texel texel;
  texel.shape = box.shape;
  const auto linear = [&](const Matter& voxel) {
    const openvdb::Coord at = voxel.at - box.first;
    return texel.shape.linear(texel.shape.wrapped(at.x()), texel.shape.wrapped(at.y()), at.z());
  };
  std::stable_sort(matter.begin(), matter.end(),
                   [&](const Matter& a, const Matter& b) { return linear(a) < linear(b); });
  for (const Matter& voxel : matter) {
    texel.voxel.push_back(linear(voxel));
    texel.density.push_back(voxel.density);
  }
  const glm::vec3 up(0.0F, 0.0F, 1.0F), mesophyll(1.0F, 0.0F, 0.0F);
  texel.tangent.assign(matter.size(), up);
  texel.normal.assign(matter.size(), mesophyll);
  texel.specular.assign(matter.size(), 0.0F);
  read_values<openvdb::Vec3SGrid>(*grids, "tangent", matter, texel.tangent,
                                  [&](const auto& value) { return unit_or(value, up); });
  read_values<openvdb::Vec3SGrid>(*grids, "normal", matter, texel.normal, [&](const auto& value) {
    return unit_or(value, glm::vec3(0.0F));
  });
  read_values<openvdb::FloatGrid>(*grids, "specular", matter, texel.specular,
                                  [](float value) { return value; });
  if (openvdb::findGridByName(*grids, "albedo")) {
    texel.albedo.resize(matter.size());
    read_values<openvdb::Vec3SGrid>(*grids, "albedo", matter, texel.albedo, [](const auto& value) {
      const glm::vec3 albedo(value.x(), value.y(), value.z());
      return glm::all(glm::greaterThanEqual(albedo, glm::vec3(0.0F))) ? glm::min(albedo, 0.99F)
                                                                      : glm::vec3(0.0F);
    });
  }
  return texel;
}

Texel fitted_to_patch(Texel texel, double patch_m) {
  const double scale = patch_m / texel.shape.patch_m();
  texel.shape.voxel_m *= scale;
  for (float& density : texel.density) density = static_cast<float>(double{density} / scale);
  return texel;
}

}  // namespace wold::grass
